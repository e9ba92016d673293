// Decisions on the submission that is shown, or on all that are ticked on a contact sheet.
import { $, counted, words } from "./dom.js";
import { entries, model, overrules, saidOf, standing, whenOvertaken } from "./model.js";
import { offersFor, showOffers } from "./saved.js";
import { memory } from "./server.js";
import { goOn, isOnPage, tell } from "./submission.js";
import { record, undoLast } from "./undo.js";
import { again, open, viewName } from "./views.js";

export const who = () => $("#who").value.trim();

function setWho(name) {
  $("#who").value = name;
  memory.set("who", name);
}

/// Asks in a dialog for the name or the reason, then calls the continuation with the comment.
///
/// why: {isRequired, comment, offers}; null where no comment is asked for.
export function askFor(title, why, then) {
  const dialog = $("#ask");
  const [name, reason] = [$("#ask-who"), $("#ask-why")];
  $("h2", dialog).textContent = title;
  name.closest("label").hidden = who() !== "";
  name.disabled = who() !== "";
  name.value = "";
  reason.closest("label").hidden = !why;
  reason.disabled = !why;
  reason.required = why?.isRequired ?? false;
  reason.value = why?.comment ?? "";
  showOffers($(".offers", dialog), why?.offers ?? [], (text) => { reason.value = text; reason.focus(); });
  $("form", dialog).onsubmit = (event) => {
    if (event.submitter?.value === "cancel") return;
    if (reason.required && !reason.value.trim()) return event.preventDefault(); // a reason of blanks is refused
    if (!name.disabled) setWho(name.value.trim());
    then(reason.value.trim());
  };
  dialog.showModal();
  (name.disabled ? reason : name).focus();
}

/// What stands, for another ruling, which is about the files that are shown.
const anew = (name) => ({ ...saidOf(standing(name)), bulk: "", files: "" });

/// Decides on the submission that is shown, and opens the next one. Asks once for a name; for a reason if
/// the decision contradicts the proposal; and, if a decision is reversed, whether its comment still fits.
function decideOne(ruling) {
  if (!isOnPage()) return; // the submission is not shown yet
  const name = model.current;
  const entry = entries.get(name);
  const over = saidOf(standing(name));
  const isAgainst = overrules(ruling, entry);
  const isTurned = over.ruling !== "undecided" && over.ruling !== ruling;
  const keep = (comment) => {
    record([{ submission: name, over, made: { ...anew(name), ruling, comment } }], who());
    goOn();
  };
  if (over.comment ? isTurned : isAgainst)
    askFor(over.comment ? "Does your comment still fit?" : `The proposal is “${words[entry.verdict]}”. Why “${words[ruling]}”?`,
      { isRequired: isAgainst, comment: over.comment, offers: offersFor(entry).filter(({ isSaved }) => isSaved) }, keep);
  else if (!who()) askFor("Who decides?", null, () => keep(over.comment));
  else keep(over.comment);
}

/// Decides on many submissions: the same ruling for all, the same comment for those without one.
export function decideMany(names, ruling) {
  if (names.length === 0) return;
  const all = names.map((name) => entries.get(name));
  const isAgainst = all.some((entry) => overrules(ruling, entry) && !standing(entry.name).comment);
  const overs = names.map((name) => saidOf(standing(name)));
  const title = `“${words[ruling]}” for ${counted(names.length, "submission")}${isAgainst ? ". Some proposals differ: why?" : "?"}`;
  askFor(title, { isRequired: isAgainst, comment: "", offers: offersFor(all[0]) }, (comment) => {
    const bulk = Math.random().toString(36).slice(2, 10);
    record(names.map((submission, i) => {
      const before = anew(submission);
      return { submission, over: overs[i], made: { ...before, ruling, bulk, comment: before.comment || comment } };
    }), who());
    again();
    tell(`“${words[ruling]}” for ${counted(names.length, "submission")}; one undo takes them back.`);
  });
}

let bulkNames = () => [];
/// Sets the function that returns the names to decide on where no single submission is shown.
export const decidesAbout = (names) => { bulkNames = names; };

export function decide(ruling) {
  if (model.current !== null) return decideOne(ruling);
  if (viewName() === "sheet") decideMany(bulkNames(), ruling);
}

export function undo() {
  const back = undoLast(who());
  if (!back) return;
  if (back.submission) return open("submission", { name: back.submission });
  if (model.current === null) again();
  tell(back.text);
}

const inWords = ({ ruling, comment, notes }) => [`${words[ruling]}${comment && ` (“${comment}”)`}`,
  ...notes.map(({ file, line, text }) => `in line ${line} of ${file} “${text}”`)].join(", ");

export function watchDecisions() {
  $("#who").value = memory.get("who", "");
  $("#who").addEventListener("input", (event) => memory.set("who", event.target.value));
  whenOvertaken(async (mine, theirs) => {
    const dialog = $("#conflict");
    $(".words", dialog).textContent = `${theirs.who || "Another ticker"} decided about ` +
      `${entries.get(mine.submission)?.shown} meanwhile: ${inWords(theirs)}. You said: ${inWords(mine)}.`;
    dialog.returnValue = "theirs";
    dialog.showModal();
    await new Promise((done) => dialog.addEventListener("close", done, { once: true }));
    return dialog.returnValue;
  });
}
