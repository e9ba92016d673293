// The class as this page knows it. What is decided goes into a queue that outlives the page; the queue is
// sent in order, again and again until the session says that it is on disk.
import { ask, memory, post, token } from "./server.js";

export const entries = new Map(); // name -> what the session says of it, and its row of the list
export const model = { names: [], comments: [], current: null }; // current: the name that fills the page
const watchers = [];
export const watch = (work) => watchers.push(work);
/// Tells the page that decisions changed; with `names`, about these alone.
export const changed = (names = null) => { for (const work of watchers) work(names); };

// --- what is sent --------------------------------------------------------------------------------

const queueKey = `queue.${Math.random().toString(36).slice(2)}`; // each tab has its own
const mostBytes = 150_000; // of one request
let queue = adoptQueues(); // {submission, version, ruling, comment, notes, bulk, who}
let latest = null; // name -> its last one of the queue

/// What tabs that are gone had not sent. A tab that still lives sends its own again, which does no harm.
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

let disputed = 0; // what another ticker was faster with, and nobody has said yet whose holds
export const waiting = () => queue.length + disputed;

function pendingOf(name) {
  latest ??= new Map(queue.map((item) => [item.submission, item]));
  return latest.get(name);
}
export const isPending = (name) => pendingOf(name) !== undefined;

const nothing = { ruling: "undecided", comment: "", notes: [], bulk: "" };

/// What stands for a submission, on disk or on its way there.
export const standing = (name) => ({ ...nothing, ...(pendingOf(name) || entries.get(name)?.decision) });

/// What of it a person says.
export const saidOf = ({ ruling, comment, notes, bulk }) => ({ ruling, comment, notes, bulk });
export const isSame = (one, other) => one.ruling === other.ruling && one.comment === other.comment &&
  JSON.stringify(one.notes) === JSON.stringify(other.notes);

// Where the tool proposes no verdict ("needs a look"), none is overruled.
export const overrules = (ruling, entry) =>
  (ruling === "awarded" && entry.verdict === "notAwarded") || (ruling === "notYet" && entry.verdict === "awarded");
export const isOverruled = (entry) => overrules(standing(entry.name).ruling, entry);
export const isOpen = (name) => standing(name).ruling === "undecided";
/// True where the files that were decided about are no longer those that were handed in last.
export const isStale = ({ decision, files }) =>
  Boolean(decision && decision.ruling !== "undecided" && decision.files && decision.files !== files);

/// Keeps decisions: [{submission, ruling, comment, notes, bulk}].
export function enqueue(items, who) {
  const next = new Map();
  const versioned = items.map((item) => {
    const known = entries.get(item.submission)?.decision?.version ?? 0;
    const before = next.get(item.submission) ?? queue.filter((one) => one.submission === item.submission).length;
    next.set(item.submission, before + 1);
    return { ...item, version: known + before, who };
  });
  setQueue([...queue, ...versioned]);
  changed(items.map((item) => item.submission));
  flush();
}

/// The oldest of the queue, each submission once: what follows a decision needs its version.
function batch() {
  const items = [];
  const seen = new Set();
  let size = 0;
  for (const item of queue) {
    size += JSON.stringify(item).length;
    if (seen.has(item.submission) || (items.length > 0 && size > mostBytes)) break;
    seen.add(item.submission);
    items.push(item);
  }
  return items;
}

let isFlushing = false;
const conflicts = { resolve: () => "theirs" };
/// Says who asks whose decision holds: `resolve(mine, theirs)` gives "mine" or "theirs".
export const whenOvertaken = (resolve) => { conflicts.resolve = resolve; };

/// Sends what waits, oldest first.
export async function flush() {
  if (isFlushing) return;
  isFlushing = true;
  while (queue.length > 0) {
    const items = batch();
    const { status, answer } = await post("decide", { decisions: items });
    setQueue(queue.slice(items.length));
    if (status !== 200) alert(`Not kept: ${answer.error}`);
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
}

/// Two decided about one submission: the later one says whose holds. Both stay in the history.
async function settle(mine, theirs) {
  // What was meant to follow a decision that did not come to be.
  setQueue(queue.filter((item) => item.submission !== mine.submission));
  if (isSame({ ...nothing, ...theirs }, { ...nothing, ...mine })) return;
  memory.set(queueKey, [mine, ...queue]); // not lost, should the page be closed now
  disputed = 1;
  changed([]);
  const holds = await conflicts.resolve(mine, theirs);
  disputed = 0;
  setQueue(holds === "mine" ? [...queue, { ...mine, version: theirs.version }] : queue);
}

// --- what comes ----------------------------------------------------------------------------------

let known = ""; // what the session calls the state that this page has seen

/// Asks what the class is now. Gives false where nothing has changed.
export async function loadClass() {
  const { state, submissions, comments } = await ask(`class?known=${known}`);
  if (state === known) return false;
  known = state;
  for (const one of submissions) {
    const known = entries.get(one.name) || {};
    const isOlder = (one.decision?.version ?? 0) < (known.decision?.version ?? 0); // it was overtaken
    entries.set(one.name, Object.assign(known, one, isOlder ? { decision: known.decision } : {}));
  }
  const isSameClass = submissions.length === model.names.length && submissions.every(({ name }, i) => name === model.names[i]);
  if (!isSameClass) model.names = submissions.map((one) => one.name);
  model.comments = comments;
  changed();
  return true;
}
