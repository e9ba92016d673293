// The editor of comments for the student, on the submission or on a line, with a preview.
import { $, make } from "./dom.js";
import { entries, isSameNote, model, saidOf, standing, whenRefused } from "./model.js";
import { askFor, who } from "./decide.js";
import { filled, offersFor, saveComment, showOffers } from "./saved.js";
import { memory, post } from "./server.js";
import { isOnPage } from "./submission.js";
import { record } from "./undo.js";
import { codeChanged } from "./code.js";

const previewMs = 120;

/// Shows Markdown in an element as the student will see it.
export async function showMarkdown(place, text) {
  place.dataset.text = text;
  if (!text.trim()) return place.replaceChildren();
  const { answer: { html } } = await post("preview", { text });
  if (place.dataset.text === text) place.innerHTML = html; // made by the session, which escapes HTML in it
}

const draftOf = (name, at) => `draft.${name}${at ? `.${at.file}.${at.line}` : ""}`;

/// The words of a decision that was not kept are in the editor when it is opened next.
function keepWords({ submission, comment, notes }) {
  const { decision } = entries.get(submission) ?? {};
  if (comment && comment !== decision?.comment) memory.set(draftOf(submission), comment);
  const isKept = (note) => (decision?.notes ?? []).some((one) => isSameNote(one, note));
  for (const note of notes) if (!isKept(note)) memory.set(draftOf(submission, note), note.text);
}

const mostTold = 10;

export function watchComments() {
  whenRefused(keepWords, (refused) => {
    const lines = refused.slice(0, mostTold).map(([{ submission }, why]) => `${entries.get(submission)?.shown ?? submission}: ${why}`);
    const rest = refused.length > mostTold ? [`and ${refused.length - mostTold} more`] : [];
    alert(["Not kept:", ...lines, ...rest, "What was written is in the editor of its comment, and of its lines, when you open it."].join("\n"));
  });
}

let timer = 0;
function previewSoon(dialog) {
  clearTimeout(timer);
  timer = setTimeout(() => showMarkdown($(".preview .words", dialog), $("textarea", dialog).value), previewMs);
}

const isMissing = (text, one) => !text.includes(one);

/// Opens the editor with the present text, offers and a preview. `keep` is called with the new text.
function edit({ title, draft, text, offers, at, keep }) {
  const entry = entries.get(model.current);
  const dialog = $("#comment");
  const area = $("textarea", dialog);
  $("h2", dialog).textContent = title;
  area.value = memory.get(draft, text);
  const show = () => { memory.set(draft, area.value); previewSoon(dialog); };
  const insert = (words) => {
    area.value = [area.value.trim(), ...words.filter((one) => isMissing(area.value, one))].filter(Boolean).join("\n\n");
    show();
    area.focus();
  };
  area.oninput = show;
  showOffers($(".offers", dialog), offers, (one) => insert([one]));
  const quoted = offers.filter(({ isSaved, isHint }) => !isSaved && !isHint).map((one) => one.text);
  const quote = $("[data-act=quote]", dialog);
  quote.disabled = quoted.length === 0;
  quote.onclick = () => insert(quoted);
  $("#save-for").replaceChildren(make("option", { value: "" }, "anybody"),
    ...[...new Set(entry.findings)].map((id) => make("option", { value: id, selected: "" }, id)));
  $("[data-act=keepWords]", dialog).onclick = async () => {
    if (!area.value.trim()) return;
    await saveComment($("#save-for").value, area.value.trim(), who());
    $(".kept", dialog).textContent = "Saved for the tickers of this class.";
  };
  $(".kept", dialog).textContent = "";
  $("form", dialog).onsubmit = (event) => {
    const said = filled(area.value.trim(), entry, at);
    if (event.submitter?.value === "save" && said !== text) keep(said);
  };
  dialog.onclose = () => memory.remove(draft);
  showMarkdown($(".preview .words", dialog), area.value);
  dialog.showModal();
  area.focus();
}

export function editComment() {
  if (!isOnPage()) return;
  if (!who()) return askFor("Who comments?", null, editComment);
  const name = model.current;
  const entry = entries.get(name);
  const over = saidOf(standing(name));
  edit({
    title: "Comment for the student", draft: draftOf(name), text: over.comment, offers: offersFor(entry), at: {},
    keep: (comment) => record([{ submission: name, over, made: { ...saidOf(standing(name)), comment } }], who()),
  });
}

/// Edits the comment on a line: {file, line, code}. An empty text removes the comment.
export function editNote(at) {
  if (!isOnPage()) return;
  if (!who()) return askFor("Who comments?", null, () => editNote(at));
  const name = model.current;
  const isHere = (note) => note.file === at.file && note.line === at.line;
  const over = saidOf(standing(name));
  const before = over.notes.find(isHere);
  edit({
    title: `${at.file}, line ${at.line}`, draft: draftOf(name, at), text: before?.text ?? "",
    offers: offersFor(entries.get(name), at), at,
    keep: (text) => {
      const said = saidOf(standing(name));
      const notes = [...said.notes.filter((note) => !isHere(note)), ...(text ? [{ ...at, text }] : [])]
        .sort((one, other) => one.file.localeCompare(other.file) || one.line - other.line);
      record([{ submission: name, over, made: { ...said, notes } }], who());
      codeChanged();
    },
  });
}
