// What this page can take back: single decisions, comments, and bulk decisions as one.
import { counted, words } from "./dom.js";
import { enqueue, isSame, saidOf, standing } from "./model.js";

const steps = []; // each a list of {submission, before, made}
export const undone = new Map(); // name -> {text, said}: what the last undo did, and what stands since
export const canUndo = () => steps.length > 0;

/// Keeps what is said about submissions, [{submission, made}], so that one undo takes it back.
export function record(items, who) {
  steps.push(items.map(({ submission, made }) => ({ submission, made, before: saidOf(standing(submission)) })));
  for (const { submission } of items) undone.delete(submission);
  enqueue(items.map(({ submission, made }) => ({ submission, ...made })), who);
}

function wordsFor({ before, made }) {
  if (made.ruling !== before.ruling) return `taken back: ${words[made.ruling]}`;
  return made.comment === before.comment ? "line comment taken back" : "comment taken back";
}

/// Takes the last step back where it still stands. Gives {submission} for a single one, {text} for a
/// bulk; nothing where there is none.
export function undoLast(who) {
  const step = steps.pop();
  if (!step) return null;
  const back = [];
  for (const item of step) {
    const now = saidOf(standing(item.submission));
    const stands = isSame(now, item.made);
    if (stands) back.push({ submission: item.submission, ...item.before });
    undone.set(item.submission, {
      text: stands ? wordsFor(item) : "nothing taken back: decided again meanwhile", said: stands ? item.before : now,
    });
  }
  if (back.length > 0) enqueue(back, who);
  if (step.length === 1) return { submission: step[0].submission };
  const rest = step.length - back.length;
  return {
    text: `taken back: ${words[step[0].made.ruling]}, for ${counted(back.length, "submission")}` +
      (rest > 0 ? `; ${rest} decided again meanwhile` : ""),
  };
}
