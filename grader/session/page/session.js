// The page of a ticking session. What is decided goes into a queue that outlives the page; the queue
// is sent in order, again and again until the session says that it is on disk.

const token = location.pathname.split("/")[1];
const $ = (selector, root = document) => root.querySelector(selector);
const words = {
  awarded: "awarded", notAwarded: "not awarded", needsReview: "needs a look", notGraded: "not graded",
  notYet: "not yet", undecided: "undecided",
};
const retryMs = 700;
const refreshMs = 5000;
const wait = (ms) => new Promise((done) => setTimeout(done, ms));

/// Makes an element: make("p", {class: "soft"}, "text", child, ...).
function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/// Something that this browser remembers for this class.
const memory = {
  get: (key, otherwise) => {
    try {
      return JSON.parse(localStorage.getItem(`ticker.${token}.${key}`)) ?? otherwise;
    } catch {
      return otherwise;
    }
  },
  set: (key, value) => localStorage.setItem(`ticker.${token}.${key}`, JSON.stringify(value)),
  remove: (key) => localStorage.removeItem(`ticker.${token}.${key}`),
};

/// What tabs that are gone had not sent. A tab that still lives sends its own again, which does no harm.
function adoptQueues() {
  const prefix = `ticker.${token}.`;
  const found = Object.keys(localStorage).filter((key) => key.startsWith(`${prefix}queue.`));
  const items = found.flatMap((key) => memory.get(key.slice(prefix.length), []));
  memory.set(queueKey, items);
  for (const key of found) localStorage.removeItem(key);
  return items;
}

function keepQueue(items = queue) {
  memory.set(queueKey, items);
}

/// Asks the session, as often as it takes. Gives the response.
async function request(path, options) {
  for (;;) {
    try {
      const response = await fetch(path, options);
      if (response.status !== 503) {
        setOnline(true);
        return response;
      }
    } catch {
      setOnline(false);
    }
    await wait(retryMs);
  }
}

const entries = new Map(); // name -> {name, shown, verdict, option, findings, decision, row}
let order = [];
let current = null; // the name that fills the page; null: the summary
let trail = []; // where the ticker was
const undos = []; // {submission, before, made}, both {ruling, comment}
const undone = new Map(); // name -> {text, ruling, comment}: what the last undo did, and what stood then
const queueKey = `queue.${Math.random().toString(36).slice(2)}`; // each tab has its own
let queue = adoptQueues(); // {submission, version, ruling, comment, who}
let online = true;
let viewers = []; // of the submission that fills the page

// --- the class ---------------------------------------------------------------------------------

const decisionOf = (name) => entries.get(name)?.decision;
const pendingOf = (name) => queue.filter((item) => item.submission === name);

/// What stands for a submission, on disk or on its way there.
function standing(name) {
  const pending = pendingOf(name).at(-1);
  return pending || decisionOf(name) || { ruling: "undecided", comment: "" };
}

/// Where the tool proposes no verdict ("needs a look"), none is overruled.
const overrules = (ruling, entry) =>
  (ruling === "awarded" && entry.verdict === "notAwarded") || (ruling === "notYet" && entry.verdict === "awarded");
const isOverruled = (entry) => overrules(standing(entry.name).ruling, entry);

async function loadClass() {
  const { submissions } = await (await request("class")).json();
  const same = submissions.length === order.length && submissions.every((one) => entries.has(one.name));
  for (const one of submissions) {
    const known = entries.get(one.name) || {};
    const isOlder = (one.decision?.version ?? 0) < (known.decision?.version ?? 0); // it was overtaken
    entries.set(one.name, Object.assign(known, one, isOlder ? { decision: known.decision } : {}));
  }
  if (!same) {
    order = submissions.map((one) => one.name);
    buildList();
  }
  for (const name of order) showRow(name);
  filterList();
  showCounts();
}

function buildList() {
  const list = $(".list");
  list.replaceChildren(...order.map((name) => {
    const entry = entries.get(name);
    entry.mark = make("span", { class: "mark", "aria-hidden": "true" });
    entry.told = make("span", { class: "unseen" }); // the mark and the colour in words
    entry.button = make("button", { type: "button" }, entry.mark,
      make("span", { class: "name" }, entry.shown), entry.told,
      make("span", { class: "found soft" }, [...new Set(entry.findings)].join(" ")));
    entry.button.addEventListener("click", () => showSubmission(name));
    entry.row = make("li", {}, entry.button);
    return entry.row;
  }));
}

function showRow(name) {
  const entry = entries.get(name);
  const { ruling } = standing(name);
  const pending = pendingOf(name).length > 0;
  const sign = { awarded: "✓", notYet: "✗", undecided: "" }[ruling];
  Object.assign(entry.row.dataset, { verdict: entry.verdict, ruling });
  entry.mark.textContent = pending ? `${sign}…` : sign;
  entry.told.textContent = `, proposed: ${words[entry.verdict]}, ${words[ruling]}${pending ? ", not saved yet" : ""} `;
  if (name === current) entry.button.setAttribute("aria-current", "true");
  else entry.button.removeAttribute("aria-current");
}

function showCounts() {
  const decided = order.filter((name) => standing(name).ruling !== "undecided").length;
  const progress = $(".progress");
  progress.setAttribute("aria-valuemax", order.length);
  progress.setAttribute("aria-valuenow", decided);
  $(".bar", progress).style.inlineSize = `${order.length ? (100 * decided) / order.length : 0}%`;
  $(".count", progress).textContent = `${decided} of ${order.length} decided`;
  showState();
}

function showState() {
  const state = $(".state");
  const waiting = queue.length;
  const text = online
    ? waiting ? `saving ${waiting} ...` : "all saved"
    : `the session does not answer; ${waiting} ${waiting === 1 ? "decision waits" : "decisions wait"} in this browser`;
  if (state.textContent !== text) state.textContent = text;
  state.classList.toggle("trouble", !online);
}

function setOnline(now) {
  if (online === now) return;
  online = now;
  showState();
}

const filters = {
  all: () => true,
  undecided: (entry) => standing(entry.name).ruling === "undecided",
  overruled: isOverruled,
  commented: (entry) => standing(entry.name).comment !== "",
};

function filterList() {
  const wanted = $("#find").value.trim().toLowerCase();
  const kind = $("#show").value;
  const fits = filters[kind] || ((entry) => entry.verdict === kind);
  let shown = 0;
  for (const name of order) {
    const entry = entries.get(name);
    const found = !wanted || entry.shown.toLowerCase().includes(wanted) ||
      entry.findings.some((id) => id.includes(wanted));
    entry.row.hidden = !(found && fits(entry));
    shown += entry.row.hidden ? 0 : 1;
  }
  const text = shown === order.length ? "" : `${shown} of ${order.length} shown`;
  if ($(".shown").textContent !== text) $(".shown").textContent = text;
  showButtons();
}

function showWholeList() {
  $("#find").value = "";
  $("#show").value = "all";
  filterList();
  goOn();
}

/// A button that would do nothing cannot be pressed.
function showButtons() {
  const can = {
    award: current !== null, notYet: current !== null, comment: current !== null,
    undo: undos.length > 0, back: trail.length > 0, next: current !== null || nextUndecided() !== null,
  };
  for (const [act, is] of Object.entries(can)) $(`.buttons [data-act=${act}]`).disabled = !is;
}

// --- one submission ----------------------------------------------------------------------------

const cache = new Map(); // name -> promise of {html, history}

function fetched(name) {
  if (!cache.has(name)) {
    if (cache.size > 20) cache.delete(cache.keys().next().value);
    cache.set(name, request(`submission?name=${encodeURIComponent(name)}`).then((response) => response.json()));
  }
  return cache.get(name);
}

async function showSubmission(name, options = {}) {
  if (current !== null && current !== name && !options.isBack) trail.push(current);
  const before = current;
  current = name;
  if (before !== null && entries.has(before)) showRow(before);
  showRow(name);
  entries.get(name).row.scrollIntoView({ block: "nearest" });
  history.replaceState(null, "", `#${encodeURIComponent(name)}`);
  showStanding();
  showButtons();
  const main = $("main");
  main.classList.toggle("loading", main.dataset.name !== name);
  const { html, error } = await fetched(name);
  if (current !== name) return;
  main.classList.remove("loading");
  if (error) main.replaceChildren(make("p", { class: "soft" }, error));
  else main.innerHTML = html; // written by the session itself, everything of the student's escaped
  viewers = [...main.querySelectorAll(".viewer")].map((section) => new Viewer(section));
  window.scrollTo(0, 0);
  main.focus({ preventScroll: true });
  main.dataset.name = name;
  const following = nextUndecided();
  if (following) fetched(following);
}

/// On this machine's clock: the time today, the date and the time before.
function clock(when) {
  const at = new Date(when);
  const isToday = at.toDateString() === new Date().toDateString();
  const text = at.toLocaleString([], { ...(isToday ? {} : { dateStyle: "medium" }), timeStyle: "short" });
  return make("time", { datetime: when }, text);
}

function showStanding() {
  const place = $(".standing");
  const entry = entries.get(current);
  if (!entry) return place.replaceChildren();
  const now = standing(current);
  const soft = (...children) => make("span", { class: "soft" }, ...children);
  const parts = [soft("proposed: "), make("span", { class: `badge ${entry.verdict}` }, words[entry.verdict])];
  if (now.ruling !== "undecided")
    parts.push(soft(" decided: "),
      make("span", { class: `badge ${now.ruling === "awarded" ? "awarded" : "notAwarded"}` }, words[now.ruling]));
  if (isOverruled(entry)) parts.push(make("strong", {}, " against the proposal"));
  const note = undone.get(current);
  if (note?.ruling === now.ruling && note.comment === now.comment) parts.push(make("strong", {}, note.text));
  else if (now.ruling === "undecided" && now.who) parts.push(soft(now.comment ? " commented" : " taken back"));
  if (now.who) parts.push(soft(" by ", now.who, ...(now.when ? [", ", clock(now.when)] : [])));
  if (pendingOf(current).length > 0) parts.push(soft(" (not saved yet)"));
  if (now.comment) parts.push(make("span", { class: "remark" }, `“${now.comment}”`));
  place.replaceChildren(...parts);
}

/// The next one of the list that is not decided, from the current one on and round the list's end.
function nextUndecided() {
  const from = current === null ? -1 : order.indexOf(current);
  const isOpen = (name) =>
    name !== current && !entries.get(name).row.hidden && standing(name).ruling === "undecided";
  return order.slice(from + 1).find(isOpen) ?? order.slice(0, Math.max(from, 0)).find(isOpen) ?? null;
}

function goOn() {
  const name = nextUndecided();
  if (name === null) showSummary();
  else showSubmission(name);
}

// --- deciding ----------------------------------------------------------------------------------

const who = () => $("#who").value.trim();
const isOnPage = () => current !== null && $("main").dataset.name === current;

function enqueue(submission, { ruling, comment }) {
  const known = decisionOf(submission)?.version ?? 0;
  queue.push({ submission, version: known + pendingOf(submission).length, ruling, comment, who: who() });
  keepQueue();
  cache.delete(submission);
  showRow(submission);
  filterList();
  showCounts();
  if (submission === current) showStanding();
  flush();
}

/// Keeps a decision or a comment, so that it can be taken back.
function record(submission, made) {
  const { ruling, comment } = standing(submission);
  undos.push({ submission, before: { ruling, comment }, made });
  undone.delete(submission);
  enqueue(submission, made);
}

/// Asks for what is missing in a dialog, and goes on with the comment once it is there.
function ask(title, why, then) {
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
  $("form", dialog).onsubmit = (event) => {
    if (event.submitter?.value === "cancel") return;
    if (reason.required && !reason.value.trim()) return event.preventDefault(); // blanks are no reason
    if (!name.disabled) setWho(name.value.trim());
    then(reason.value.trim());
  };
  dialog.showModal();
  (name.disabled ? reason : name).focus();
}

function setWho(name) {
  $("#who").value = name;
  memory.set("who", name);
}

/// Decides about what fills the page, and goes on. Asks for a name once, for a reason against the
/// proposal, and whether a comment still fits a decision that is turned round.
function decide(ruling) {
  if (!isOnPage()) return; // it was not seen yet
  const name = current;
  const before = standing(name);
  const isAgainst = overrules(ruling, entries.get(name));
  const isTurned = before.ruling !== "undecided" && before.ruling !== ruling;
  const why = before.comment ? isTurned : isAgainst;
  const keep = (comment) => {
    record(name, { ruling, comment });
    goOn();
  };
  if (why)
    ask(before.comment ? "Does your comment still fit?" : `The proposal is “${words[entries.get(name).verdict]}”. Why “${words[ruling]}”?`,
      { isRequired: isAgainst, comment: before.comment }, keep);
  else if (!who()) ask("Who decides?", null, () => keep(before.comment));
  else keep(before.comment);
}

function undo() {
  const last = undos.pop();
  if (!last) return;
  const { submission, before, made } = last;
  const now = standing(submission);
  const stands = now.ruling === made.ruling && now.comment === made.comment;
  const what = made.ruling === before.ruling ? "comment taken back" : `taken back: ${words[made.ruling]}`;
  const { ruling, comment } = stands ? before : now;
  undone.set(submission, { text: stands ? what : "nothing taken back: decided again meanwhile", ruling, comment });
  if (stands) enqueue(submission, before);
  showSubmission(submission);
}

let flushing = false;

/// Sends what waits, oldest first.
async function flush() {
  if (flushing) return;
  flushing = true;
  while (queue.length > 0) {
    const item = queue[0];
    const response = await request("decide", {
      method: "POST", headers: { "Content-Type": "application/json", "X-Ticker": token }, body: JSON.stringify(item),
    });
    const answer = await response.json();
    queue = queue.slice(1);
    keepQueue();
    if (response.status === 200 || response.status === 409) settle(item, answer);
    if (response.status === 409) await resolveConflict(item, answer);
    if (response.status >= 400 && response.status !== 409) alert(`Not kept: ${answer.error}`);
    showCounts();
  }
  flushing = false;
  showState();
}

function settle(item, decision) {
  const entry = entries.get(item.submission);
  if (!entry) return;
  entry.decision = decision;
  showRow(item.submission);
  filterList();
  if (item.submission === current) showStanding();
}

/// Two decided about one submission: the later one says whose holds. Both stay in the history.
async function resolveConflict(mine, theirs) {
  // What was meant to follow a decision that did not come to be.
  queue = queue.filter((item) => item.submission !== mine.submission);
  if (theirs.ruling === mine.ruling && theirs.comment === mine.comment) return keepQueue();
  const dialog = $("#conflict");
  $(".words", dialog).textContent =
    `${theirs.who || "Another ticker"} decided about ${entries.get(mine.submission)?.shown} meanwhile: ${words[theirs.ruling]}` +
    `${theirs.comment ? ` (“${theirs.comment}”)` : ""}. You said: ${words[mine.ruling]}` +
    `${mine.comment ? ` (“${mine.comment}”)` : ""}.`;
  keepQueue([mine, ...queue]); // not lost, should the page be closed now
  dialog.returnValue = "theirs";
  dialog.showModal();
  await new Promise((done) => dialog.addEventListener("close", done, { once: true }));
  if (dialog.returnValue === "mine") queue.push({ ...mine, version: theirs.version });
  keepQueue();
}

// --- the summary -------------------------------------------------------------------------------

function countBy(list, keyOf) {
  const counts = new Map();
  for (const one of list) for (const key of [keyOf(one)].flat()) counts.set(key, (counts.get(key) || 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1]);
}

/// In a list; no table where there are no rows.
function table(caption, head, rows) {
  if (rows.length === 0) return [];
  return [make("table", {}, make("caption", {}, caption),
    make("thead", {}, make("tr", {}, ...head.map((text) => make("th", { scope: "col" }, text)))),
    make("tbody", {}, ...rows.map((cells) => make("tr", {}, ...cells.map((cell) => make("td", {}, cell))))))];
}

function linkTo(name) {
  const link = make("button", { type: "button", class: "link" }, entries.get(name).shown);
  link.addEventListener("click", () => showSubmission(name));
  return link;
}

function showSummary() {
  if (current !== null) trail.push(current);
  const before = current;
  current = null;
  if (before !== null) showRow(before);
  showStanding();
  showButtons();
  const all = order.map((name) => entries.get(name));
  const ruling = (entry) => standing(entry.name).ruling;
  const undecided = all.filter((entry) => ruling(entry) === "undecided");
  const overruled = all.filter(isOverruled);
  const main = $("main");
  main.classList.remove("loading");
  delete main.dataset.name;
  const isListDone = undecided.length > 0 && undecided.every((entry) => entry.row.hidden);
  main.replaceChildren(make("h1", {}, undecided.length === 0 ? "All are decided"
    : isListDone ? "All that the list shows are decided" : "How far you are"),
    make("p", {}, ["awarded", "notYet", "undecided"]
      .map((word) => `${all.filter((entry) => ruling(entry) === word).length} ${words[word]}`).join(", "),
      ` of ${all.length}.`),
    ...(isListDone ? [make("button", { type: "button", "data-act": "wholeList" }, "Show the whole list")] : []),
    ...table("Who decided", ["Ticker", "Decisions"],
      countBy(all.filter((entry) => ruling(entry) !== "undecided"), (entry) => standing(entry.name).who || "no name")
        .map(([who, count]) => [who, String(count)])),
    ...table("Decided against the proposal", ["Submission", "Proposed", "Decided", "Why"],
      overruled.map((entry) => [linkTo(entry.name), words[entry.verdict], words[ruling(entry)], standing(entry.name).comment])),
    ...table("Most frequent findings", ["Finding", "Submissions"],
      countBy(all, (entry) => [...new Set(entry.findings)]).slice(0, 12).map(([id, count]) => [id, String(count)])),
    ...table("Still open", ["Submission", "Proposed"],
      undecided.slice(0, 50).map((entry) => [linkTo(entry.name), words[entry.verdict]])));
  window.scrollTo(0, 0);
}

// --- dialogs and keys --------------------------------------------------------------------------

/// The messages of the mistakes and warnings on the page, each once.
const foundWords = () => [...new Set(
  [...document.querySelectorAll("main .card.fail > .message, main .card.warn > .message")].map((one) => one.textContent.trim()))];

function editComment() {
  if (!isOnPage()) return;
  if (!who()) return ask("Who comments?", null, editComment);
  const name = current;
  const dialog = $("#comment");
  const text = $("textarea", dialog);
  const draft = `draft.${name}`; // outlives the page, not the dialog
  text.value = memory.get(draft, standing(name).comment);
  text.oninput = () => memory.set(draft, text.value);
  $("[data-act=quote]", dialog).disabled = foundWords().length === 0;
  $("form", dialog).onsubmit = (event) => {
    const { ruling, comment } = standing(name);
    const said = text.value.trim();
    if (event.submitter?.value === "save" && said !== comment) record(name, { ruling, comment: said });
  };
  dialog.onclose = () => memory.remove(draft);
  dialog.showModal();
  text.focus();
}

function quoteFindings() {
  const text = $("#comment textarea");
  const missing = foundWords().filter((one) => !text.value.includes(one));
  text.value = [text.value.trim(), ...missing].filter(Boolean).join("\n");
  text.oninput();
  text.focus();
}

const acts = {
  award: () => decide("awarded"),
  notYet: () => decide("notYet"),
  comment: editComment,
  quote: quoteFindings,
  undo,
  next: goOn,
  back: () => { const name = trail.pop(); if (name !== undefined) showSubmission(name, { isBack: true }); },
  summary: showSummary,
  wholeList: showWholeList,
  help: () => $("#help").showModal(),
  find: () => { $("#find").focus(); $("#find").select(); },
  report: () => current !== null && window.open(`report?name=${encodeURIComponent(current)}`, "_blank", "noopener"),
};
const keys = {
  a: "award", n: "notYet", c: "comment", u: "undo", j: "next", k: "back", s: "summary", "?": "help",
  "/": "find", o: "report",
};

document.addEventListener("keydown", (event) => {
  if (event.target.matches("dialog textarea")) {
    // A comment has lines, a reason has one.
    const isEnd = event.key === "Enter" && (event.target.id === "ask-why" || event.ctrlKey || event.metaKey);
    if (isEnd) event.preventDefault();
    if (isEnd) $("button[value=save]", event.target.form).click();
    return;
  }
  if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector("dialog[open]")) return;
  // A letter means the same on the filter's list and on a slider.
  if (event.target.matches("input:not([type=range])")) return;
  const look = { b: "blink", "+": "in", "=": "in", "-": "out" }[event.key];
  if (look && viewers.length > 0) viewerInSight(viewers).act(look);
  const act = keys[event.key];
  if (!act) return;
  event.preventDefault();
  acts[act]();
});
document.addEventListener("click", (event) => {
  const act = event.target.closest("[data-act]")?.dataset.act;
  if (act && acts[act]) acts[act]();
});
$("#find").addEventListener("input", filterList);
$("#show").addEventListener("change", filterList);
$("#find").addEventListener("keydown", (event) => {
  if (event.key === "Escape") { event.target.value = ""; filterList(); event.target.blur(); }
  if (event.key === "Enter") order.map((name) => entries.get(name)).find((entry) => !entry.row.hidden)?.button.click();
});
$("#who").value = memory.get("who", "");
$("#who").addEventListener("input", (event) => memory.set("who", event.target.value));

// --- beginning ---------------------------------------------------------------------------------

async function begin() {
  await loadClass();
  flush();
  const wanted = decodeURIComponent(location.hash.slice(1));
  if (entries.has(wanted)) showSubmission(wanted);
  else goOn();
  for (;;) {
    await wait(refreshMs);
    if (document.visibilityState === "visible" && !flushing) await loadClass().then(showStanding);
  }
}
begin();
