// Texts that the editor offers: the tool's messages first, then comments that tickers of the class saved.
import { button, make } from "./dom.js";
import { model } from "./model.js";
import { post } from "./server.js";

/// "Ann Lee" of "Ann Lee_1001": Moodle appends a number to the name.
const personOf = (entry) => entry.shown.replace(/_\d+$/, "");

/// Replaces {name}, {file}, {line}, {code}, {from} and {to} in a saved comment. A name without a value
/// stays as it is, so that the ticker sees it.
export function filled(text, entry, at = {}) {
  const proven = entry.proven ?? [];
  const isHere = ({ file, line }) => at.line === undefined || (file === at.file && line === at.line);
  const known = { name: personOf(entry), ...(proven.find(isHere) ?? {}), ...at };
  return text.replace(/\{(\w+)\}/g, (whole, key) => (known[key] === undefined ? whole : String(known[key])));
}

/// Messages and hints of the submission that is shown, without repetitions: [{text, isHint}].
function toolWords() {
  const found = [...document.querySelectorAll("main .findings .card:is(.fail, .warn) > :is(.message, .hint)")].map((one) =>
    ({ text: one.textContent.trim().replace(/^Hint\. /, ""), isHint: one.matches(".hint") }));
  return found.filter((one, i) => found.findIndex(({ text }) => text === one.text) === i);
}

/// The texts to offer for a submission: [{text, isSaved, isHint, id, who}].
///
/// at: {file, line, code} for a comment on a line.
export function offersFor(entry, at = {}) {
  const own = toolWords().map((one) => ({ ...one, isSaved: false }));
  const isFitting = ({ finding }) => !finding || entry.findings.includes(finding);
  const saved = model.comments.filter(isFitting)
    .sort((one, other) => Number(!one.finding) - Number(!other.finding))
    .map((one) => ({ ...one, text: filled(one.text, entry, at), isSaved: true }));
  return [...own, ...saved];
}

/// Shows offers as buttons; `take` is called with the chosen text.
export function showOffers(list, offers, take) {
  list.hidden = offers.length === 0;
  list.replaceChildren(...offers.map((offer) => {
    const tag = offer.isSaved ? `saved by ${offer.who || "no name"}${offer.finding ? ` for ${offer.finding}` : ""}` : offer.isHint ? "hint" : "found";
    const row = make("li", {}, button([make("span", { class: "soft" }, tag), " ", offer.text], () => take(offer.text), { class: "offer" }));
    if (offer.isSaved)
      row.append(button("×", async () => { await dropComment(offer.id); row.remove(); },
        { class: "drop", "aria-label": `No longer offer: ${offer.text.slice(0, 60)}` }));
    return row;
  }));
}

export async function saveComment(finding, text, who) {
  await post("save-comment", { finding, text, who });
  if (!model.comments.some((one) => one.finding === finding && one.text === text))
    model.comments.push({ id: 0, finding, text, who });
}

async function dropComment(id) {
  await post("drop-comment", { id });
  model.comments = model.comments.filter((one) => one.id !== id);
}
