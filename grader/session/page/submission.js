// The view of one submission, and the footer with its decision.
import { $, badge, button, clock, make, soft, table, words } from "./dom.js";
import { dressCode } from "./code.js";
import { entries, gradingOf, isOverruled, isPending, isSame, isStale, model, shown, standing, watch } from "./model.js";
import { nextUndecided } from "./list.js";
import { ask } from "./server.js";
import { undone } from "./undo.js";
import { Viewer, drawRays } from "./viewer.js";
import { again, onOpen, open, register } from "./views.js";

export let viewers = []; // of the submission that is shown
const cache = new Map(); // grading, decision and name -> promise of {html, files, history}, or of {error} until it has come

function fetched(name) {
  const key = `${gradingOf(entries.get(name))} ${entries.get(name).decision?.version} ${name}`;
  if (!cache.has(key)) {
    if (cache.size > 20) cache.delete(cache.keys().next().value);
    cache.set(key, ask(`submission?name=${encodeURIComponent(name)}`));
    cache.get(key).then(({ error }) => { if (error) cache.delete(key); }); // next time it may be there
  }
  return cache.get(key);
}

/// True if the current submission is loaded and shown.
export const isOnPage = () => model.current !== null && $("main").dataset.name === model.current;

/// A table of all decisions so far; empty if the footer shows as much.
function decisionsSoFar(history, files) {
  const isOld = (one) => Boolean(one.files) && one.files !== files;
  if (history.length < 2 && !history.some(isOld)) return [];
  const [all] = table("Decisions so far", ["When", "Ticker", "Decision", "Comment"],
    history.map((one) => [clock(one.when), one.who, words[one.ruling] + (one.bulk ? ", in bulk" : "") + (isOld(one) ? ", about an earlier hand-in" : ""), one.comment]));
  return [make("details", { class: "card" }, make("summary", {}, `${history.length} decisions so far`), all)];
}

/// A link to the two files beside each other, for each one that is similar.
function similarOnes({ similar }) {
  if (similar.length === 0) return [];
  const names = similar.map(({ name, percent }) => `${entries.get(name)?.shown ?? name} (${percent} %)`).join(", ");
  return [make("p", { class: "soft" }, `Shares code with ${names}. `,
    make("a", { href: "similar", target: "_blank", rel: "noopener" }, "Compare the files"))];
}

async function show({ name }) {
  entries.get(name).row.scrollIntoView({ block: "nearest" });
  const main = $("main");
  main.classList.toggle("loading", main.dataset.name !== name);
  const grading = gradingOf(entries.get(name));
  const { html, files, history, error } = await fetched(name);
  if (model.current !== name) return;
  if (!error) shown.set(name, { files, grading });
  main.classList.remove("loading");
  if (error) main.replaceChildren(make("p", { class: "soft" }, error));
  else main.innerHTML = html; // made by the session, which escapes all text of students
  if (!error) $("h1", main).after(...similarOnes(entries.get(name)));
  if (!error) main.append(...decisionsSoFar(history, entries.get(name).files));
  for (const time of main.querySelectorAll("#earlier time")) time.replaceWith(clock(time.dateTime));
  viewers = [...main.querySelectorAll(".viewer")].map((section) => new Viewer(section));
  drawRays(main);
  dressCode();
  window.scrollTo(0, 0);
  main.focus({ preventScroll: true });
  main.dataset.name = name;
  showStanding();
  performance.mark("first submission");
  const following = nextUndecided();
  if (following) fetched(following);
}

// --- the footer ----------------------------------------------------------------------------------

function ruled(now) {
  const parts = [soft(" decided: "), badge(now.ruling)];
  if (now.bulk) {
    const alike = model.names.filter((name) => standing(name).bulk === now.bulk).length;
    parts.push(make("strong", {}, alike > 1 ? ` in bulk, with ${alike - 1} more` : " in bulk"));
  }
  return parts;
}

/// Which grading came after the one that is shown, and a button to load it.
function newer(entry) {
  const seen = isOnPage() ? shown.get(entry.name) : null;
  if (!seen || (seen.files === entry.files && seen.grading === gradingOf(entry))) return [];
  return [make("strong", {}, seen.files === entry.files ? " graded again: " : " handed in again: "), button("Load it anew", again)];
}

/// Proposal, decision and comment of a submission, in words.
function standingOf(entry) {
  const now = standing(entry.name);
  const parts = [soft("proposed: "), badge(entry.verdict)];
  if (now.ruling !== "undecided") parts.push(...ruled(now));
  if (isOverruled(entry)) parts.push(make("strong", {}, " against the proposal"));
  if (isStale(entry)) parts.push(make("strong", {}, " other files than were decided about"));
  parts.push(...newer(entry));
  const note = undone.get(entry.name);
  const hasSaid = now.comment || now.notes.length > 0;
  if (note && isSame(note.said, now)) parts.push(make("strong", {}, note.text));
  else if (now.ruling === "undecided" && now.who) parts.push(soft(hasSaid ? " commented" : " taken back"));
  if (now.who) parts.push(soft(" by ", now.who, ...(now.when ? [", ", clock(now.when)] : [])));
  if (isPending(entry.name)) parts.push(soft(" (not saved yet)"));
  if (now.comment) parts.push(make("span", { class: "remark" }, `“${now.comment}”`));
  return parts;
}

/// Shows a message in the footer of views other than a submission.
export const tell = (...parts) => { if (model.current === null) $(".standing").replaceChildren(...parts); };

/// A screen reader says the footer whenever it is replaced: it is where its words differ or are about another submission.
export function showStanding() {
  const entry = entries.get(model.current);
  if (!entry) return;
  const place = $(".standing");
  const now = make("div", {}, ...standingOf(entry));
  if (place.dataset.name === entry.name && place.innerHTML === now.innerHTML) return;
  place.dataset.name = entry.name;
  place.replaceChildren(...now.childNodes);
}

export function goOn() {
  const name = nextUndecided();
  if (name === null) open("summary");
  else open("submission", { name });
}

export function watchSubmission() {
  register("submission", { show });
  onOpen(() => { tell(); showStanding(); });
  watch((names) => {
    if (model.current !== null && (names === null || names.includes(model.current))) showStanding();
  });
}
