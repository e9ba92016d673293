// The page's copy of the class. Decisions go into a queue in the browser's storage. The queue is sent in
// order, and again until the session confirms that it is on disk.
import { ask, memory, post, token } from "./server.js";

export const entries = new Map(); // name -> the session's data about it, and its row of the list
export const model = { names: [], comments: [], current: null }; // current: name of the submission that is shown
/// name -> {files, grading} of what this page showed last; decisions are about these files.
export const shown = new Map();
/// Which grading of a submission the class has.
export const gradingOf = ({ timesGraded, gradedAt }) => `${timesGraded} ${gradedAt}`;
const watchers = [];
export const watch = (work) => watchers.push(work);
/// Calls the watchers after decisions changed; `names`: which ones, if known.
export const changed = (names = null) => { for (const work of watchers) work(names); };

// --- what is sent --------------------------------------------------------------------------------

const queueKey = `queue.${Math.random().toString(36).slice(2)}`; // each tab has its own
const mostBytes = 150_000; // of one request; the session takes some more
let queue = adoptQueues(); // {submission, version, ruling, comment, notes, bulk, files, who}
let latest = null; // name -> its last decision in the queue

/// Decisions that closed tabs had not sent. A tab that is still open sends them too; each is stored once.
function adoptQueues() {
  const prefix = `ticker.${token}.`;
  const found = Object.keys(localStorage).filter((key) => key.startsWith(`${prefix}queue.`));
  const items = found.flatMap((key) => memory.get(key.slice(prefix.length), []));
  memory.set(queueKey, items);
  for (const key of found) localStorage.removeItem(key);
  return items;
}

function setQueue(items, kept = items) {
  queue = items;
  latest = null;
  memory.set(queueKey, kept);
}

let disputed = 0; // 1 while a conflict with another ticker's decision is not resolved
export const waiting = () => queue.length + disputed;

function pendingOf(name) {
  latest ??= new Map(queue.map((item) => [item.submission, item]));
  return latest.get(name);
}
export const isPending = (name) => pendingOf(name) !== undefined;

const nothing = { ruling: "undecided", comment: "", notes: [], bulk: "" };

/// The valid decision on a submission, stored or still in the queue.
export const standing = (name) => ({ ...nothing, ...(pendingOf(name) || entries.get(name)?.decision) });

/// The parts of a decision that a person enters, and the files that it is about.
export const saidOf = ({ ruling, comment, notes, bulk, files }) => ({ ruling, comment, notes, bulk, files });
export const isSameNote = (one, other) => one.file === other.file && one.line === other.line && one.text === other.text;
export const isSame = (one, other) => one.ruling === other.ruling && one.comment === other.comment &&
  one.notes.length === other.notes.length && one.notes.every((note, i) => isSameNote(note, other.notes[i]));

// A decision on "needs a look" overrules nothing, since the tool proposes no verdict there.
export const overrules = (ruling, entry) =>
  (ruling === "awarded" && entry.verdict === "notAwarded") || (ruling === "notYet" && entry.verdict === "awarded");
export const isOverruled = (entry) => overrules(standing(entry.name).ruling, entry);
export const isOpen = (name) => standing(name).ruling === "undecided";
/// True if other files were handed in after the decision.
export const isStale = ({ decision, files }) =>
  Boolean(decision && decision.ruling !== "undecided" && decision.files && decision.files !== files);

/// The files of a decision that is to be stored: those of the one that stands where only a comment changes, else
/// those that were shown.
const filesOf = ({ submission, ruling, files }) =>
  (ruling !== "undecided" && files) || (shown.get(submission) ?? entries.get(submission))?.files;

/// Adds decisions to the queue: [{submission, ruling, comment, notes, bulk, files, over}].
///
/// files: as `filesOf` takes them. over: what stood when the ticker began to write; if another ticker's decision came
/// since then, the session refuses the new one, as if this page had not known of it.
export function enqueue(items, who) {
  const next = new Map();
  const versioned = items.map(({ over, ...item }) => {
    const known = entries.get(item.submission)?.decision?.version ?? 0;
    const before = next.get(item.submission) ?? queue.filter((one) => one.submission === item.submission).length;
    next.set(item.submission, before + 1);
    const isOvertaken = over && known > 0 && !isSame(over, standing(item.submission));
    return { ...item, files: filesOf(item), version: isOvertaken ? known - 1 : known + before, who };
  });
  setQueue([...queue, ...versioned]);
  changed(items.map((item) => item.submission));
  flush();
}

const bytesOf = (item) => new TextEncoder().encode(JSON.stringify(item)).length;

/// The oldest decisions of the queue, one for each submission: the next one needs the version of this one.
function batch() {
  const items = [];
  const seen = new Set();
  let size = 0;
  for (const item of queue) {
    size += bytesOf(item);
    if (seen.has(item.submission) || (items.length > 0 && size > mostBytes)) break;
    seen.add(item.submission);
    items.push(item);
  }
  return items;
}

/// Sends decisions, except a single one that the session would not read to its end.
const send = (items) => (items.length === 1 && bytesOf(items[0]) > mostBytes
  ? { status: 413, answer: { error: "Its comments are too long by far; shorten them." } } : post("decide", { decisions: items }));

/// Removes the queue's first decision, which the session refused. Later ones on this submission were to follow it.
function drop({ submission }) {
  setQueue(queue.slice(1).map((item) => (item.submission === submission ? { ...item, version: item.version - 1 } : item)));
}

const refusals = { keep: () => {}, tell: () => {} };
/// Sets the functions for decisions that are not stored: `keep(decision)` takes the words of one over, at once;
/// `tell([[decision, why], ...])` says which ones the session refused, after all others were sent.
export const whenRefused = (keep, tell) => Object.assign(refusals, { keep, tell });

let isFlushing = false;
const conflicts = { resolve: () => "theirs" };
/// Sets the function that resolves a conflict: `resolve(mine, theirs)` returns "mine" or "theirs".
export const whenOvertaken = (resolve) => { conflicts.resolve = resolve; };

/// Sends the queue, oldest first. Of decisions that are refused together, each is sent alone.
export async function flush() {
  if (isFlushing) return;
  isFlushing = true;
  let alone = 0; // so many of the queue's first are sent one by one
  const refused = [];
  while (queue.length > 0) {
    const items = alone > 0 ? queue.slice(0, 1) : batch();
    const { status, answer } = await send(items);
    if (status !== 200 && items.length > 1) {
      alone = items.length;
      continue;
    }
    alone = Math.max(alone - 1, 0);
    if (status === 200) {
      setQueue(queue.slice(items.length));
    } else {
      refusals.keep(items[0]);
      refused.push([items[0], answer.error]);
      drop(items[0]);
    }
    const overtaken = [];
    for (const [i, { isKept, decision }] of (answer.answers ?? []).entries()) {
      const entry = entries.get(items[i].submission);
      if (entry) entry.decision = decision;
      if (!isKept) overtaken.push([items[i], decision]);
    }
    changed(items.map((item) => item.submission));
    for (const [mine, theirs] of overtaken) await settle(mine, theirs);
  }
  isFlushing = false;
  changed([]);
  if (refused.length > 0) refusals.tell(refused);
}

/// Two tickers decided on one submission: the later one chooses which is valid.
async function settle(sent, theirs) {
  // Later decisions of this ticker were based on the one that was not stored; the last of them holds what was said.
  const mine = queue.findLast((item) => item.submission === sent.submission) ?? sent;
  setQueue(queue.filter((item) => item.submission !== sent.submission));
  if (isSame({ ...nothing, ...theirs }, { ...nothing, ...mine })) return;
  memory.set(queueKey, [mine, ...queue]); // kept in case the page is closed now
  disputed = 1;
  changed([]);
  const holds = await conflicts.resolve(mine, theirs);
  disputed = 0;
  if (holds !== "mine") refusals.keep(mine);
  setQueue(holds === "mine" ? [...queue, { ...mine, version: theirs.version }] : queue);
}

// --- what comes ----------------------------------------------------------------------------------

let known = ""; // digest of the state that this page has

/// Loads the class. Returns false if nothing has changed.
export async function loadClass() {
  const { state, submissions, comments } = await ask(`class?known=${known}`);
  if (state === known) return false;
  known = state;
  for (const one of submissions) {
    const known = entries.get(one.name) || {};
    const isOlder = (one.decision?.version ?? 0) < (known.decision?.version ?? 0); // the page has a newer one
    entries.set(one.name, Object.assign(known, one, isOlder ? { decision: known.decision } : {}));
  }
  const isSameClass = submissions.length === model.names.length && submissions.every(({ name }, i) => name === model.names[i]);
  if (!isSameClass) model.names = submissions.map((one) => one.name);
  model.comments = comments;
  changed();
  return true;
}
