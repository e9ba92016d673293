// Undo of this page's decisions and comments; a bulk decision is one step.
import { counted, words } from "./dom.js";
import { enqueue, isSame, saidOf, standing } from "./model.js";

const steps = []; // each a list of {submission, before, made}
export const undone = new Map(); // name -> {text, said}: a message about the last undo, and the decision after it
export const canUndo = () => steps.length > 0;

/// Stores decisions, [{submission, made, over}], as one step of undo. `over`: see `enqueue`.
export function record(items, who) {
  steps.push(items.map(({ submission, made }) => ({ submission, made, before: saidOf(standing(submission)) })));
  for (const { submission } of items) undone.delete(submission);
  enqueue(items.map(({ submission, made, over }) => ({ submission, over, ...made })), who);
}

function wordsFor({ before, made }) {
  if (made.ruling !== before.ruling) return `taken back: ${words[made.ruling]}`;
  return made.comment === before.comment ? "line comment taken back" : "comment taken back";
}

/// Undoes the last step, except decisions that another ticker has changed. Returns {submission} for a
/// single decision, {text} for a bulk one; undefined without a step.
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
