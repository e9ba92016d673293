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
async function ask(path, options) {
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
const undos = []; // {submission, ruling, comment} as it was before
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

function isOverruled(entry) {
  const { ruling } = standing(entry.name);
  return (ruling === "awarded" && entry.verdict !== "awarded") ||
    (ruling === "notYet" && entry.verdict === "awarded");
}

async function loadClass() {
  const { submissions } = await (await ask("class")).json();
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
  showCounts();
}

function buildList() {
  const list = $(".list");
  list.replaceChildren(...order.map((name) => {
    const entry = entries.get(name);
    entry.mark = make("span", { class: "mark" });
    entry.findingWords = make("span", { class: "found soft" }, entry.findings.join(" "));
    entry.button = make("button", { type: "button" }, entry.mark,
      make("span", { class: "name" }, entry.shown), entry.findingWords);
    entry.button.addEventListener("click", () => showSubmission(name));
    entry.row = make("li", {}, entry.button);
    return entry.row;
  }));
  filterList();
}

function showRow(name) {
  const entry = entries.get(name);
  const { ruling } = standing(name);
  const pending = pendingOf(name).length > 0;
  const sign = { awarded: "✓", notYet: "✗", undecided: "" }[ruling];
  Object.assign(entry.row.dataset, { verdict: entry.verdict, ruling });
  entry.mark.textContent = pending ? `${sign}…` : sign;
  entry.button.setAttribute("aria-label",
    `${entry.shown}, proposed ${words[entry.verdict]}, ${words[ruling]}${pending ? ", not saved yet" : ""}`);
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
  $(".shown").textContent = shown === order.length ? "" : `${shown} of ${order.length} shown`;
}

// --- one submission ----------------------------------------------------------------------------

const cache = new Map(); // name -> promise of {html, history}

function fetched(name) {
  if (!cache.has(name)) {
    if (cache.size > 20) cache.delete(cache.keys().next().value);
    cache.set(name, ask(`submission?name=${encodeURIComponent(name)}`).then((response) => response.json()));
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

function showStanding() {
  const place = $(".standing");
  const entry = entries.get(current);
  if (!entry) return place.replaceChildren();
  const now = standing(current);
  const pending = pendingOf(current).length > 0;
  const parts = [make("span", { class: "soft" }, "proposed: "), make("span", { class: `badge ${entry.verdict}` }, words[entry.verdict])];
  if (now.ruling !== "undecided")
    parts.push(make("span", { class: "soft" }, " decided: "),
      make("span", { class: `badge ${now.ruling === "awarded" ? "awarded" : "notAwarded"}` }, words[now.ruling]));
  if (isOverruled(entry)) parts.push(make("strong", {}, " against the proposal"));
  if (now.who || now.when)
    parts.push(make("span", { class: "soft" }, ` by ${now.who || "somebody"}${now.when ? `, ${now.when.replace("T", " ")}` : ""}`));
  if (pending) parts.push(make("span", { class: "soft" }, " (not saved yet)"));
  if (now.comment) parts.push(make("span", { class: "remark" }, `“${now.comment}”`));
  place.replaceChildren(...parts);
}

function nextUndecided() {
  const from = current === null ? -1 : order.indexOf(current);
  const isOpen = (name) => name !== current && standing(name).ruling === "undecided";
  return order.slice(from + 1).find(isOpen) ?? order.slice(0, Math.max(from, 0)).find(isOpen) ?? null;
}

function goOn() {
  const name = nextUndecided();
  if (name === null && (current === null || standing(current).ruling !== "undecided")) showSummary();
  else if (name !== null) showSubmission(name);
}

// --- deciding ----------------------------------------------------------------------------------

function enqueue(submission, ruling, comment) {
  const known = decisionOf(submission)?.version ?? 0;
  queue.push({ submission, version: known + pendingOf(submission).length, ruling, comment, who: $("#who").value.trim() });
  keepQueue();
  cache.delete(submission);
  showRow(submission);
  showCounts();
  if (submission === current) showStanding();
  flush();
}

/// False where the submission does not fill the page yet: nobody has seen it.
function decide(ruling, comment) {
  if (current === null || $("main").dataset.name !== current) return false;
  const before = standing(current);
  undos.push({ submission: current, ruling: before.ruling, comment: before.comment });
  enqueue(current, ruling, comment ?? before.comment);
  return true;
}

function undo() {
  const last = undos.pop();
  if (!last) return;
  enqueue(last.submission, last.ruling, last.comment);
  showSubmission(last.submission);
}

let flushing = false;

/// Sends what waits, oldest first.
async function flush() {
  if (flushing) return;
  flushing = true;
  while (queue.length > 0) {
    const item = queue[0];
    const response = await ask("decide", {
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
  if (item.submission === current) showStanding();
}

/// Two decided about one submission: the later one says whose holds. Both stay in the history.
async function resolveConflict(mine, theirs) {
  // What was meant to follow a decision that did not come to be.
  queue = queue.filter((item) => item.submission !== mine.submission);
  if (theirs.ruling === mine.ruling && theirs.comment === mine.comment) return keepQueue();
  const dialog = $("#conflict");
  $(".words", dialog).textContent =
    `${theirs.who || "Somebody"} decided about ${entries.get(mine.submission)?.shown} meanwhile: ${words[theirs.ruling]}` +
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

function table(caption, head, rows) {
  return make("table", {}, make("caption", {}, caption),
    make("thead", {}, make("tr", {}, ...head.map((text) => make("th", { scope: "col" }, text)))),
    make("tbody", {}, ...rows.map((cells) => make("tr", {}, ...cells.map((cell) => make("td", {}, cell))))));
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
  const all = order.map((name) => entries.get(name));
  const ruling = (entry) => standing(entry.name).ruling;
  const undecided = all.filter((entry) => ruling(entry) === "undecided");
  const overruled = all.filter(isOverruled);
  const main = $("main");
  main.classList.remove("loading");
  delete main.dataset.name;
  main.replaceChildren(make("h1", {}, undecided.length ? "How far you are" : "All are decided"),
    make("p", {}, ["awarded", "notYet", "undecided"]
      .map((word) => `${all.filter((entry) => ruling(entry) === word).length} ${words[word]}`).join(", "),
      ` of ${all.length}.`),
    table("Who decided", ["Ticker", "Decisions"],
      countBy(all.filter((entry) => ruling(entry) !== "undecided"), (entry) => standing(entry.name).who || "somebody")
        .map(([who, count]) => [who, String(count)])),
    table("Decided against the proposal", ["Submission", "Proposed", "Decided", "Why"],
      overruled.map((entry) => [linkTo(entry.name), words[entry.verdict], words[ruling(entry)], standing(entry.name).comment])),
    table("Most frequent findings", ["Finding", "Submissions"],
      countBy(all, (entry) => [...new Set(entry.findings)]).slice(0, 12).map(([id, count]) => [id, String(count)])),
    table("Still open", ["Submission", "Proposed"],
      undecided.slice(0, 50).map((entry) => [linkTo(entry.name), words[entry.verdict]])));
  window.scrollTo(0, 0);
}

// --- dialogs and keys --------------------------------------------------------------------------

async function editComment() {
  if (current === null) return;
  const name = current;
  const dialog = $("#comment");
  const text = $("textarea", dialog);
  text.value = memory.get(`draft.${name}`, standing(name).comment);
  dialog.returnValue = "cancel";
  dialog.showModal();
  text.focus();
  await new Promise((done) => dialog.addEventListener("close", done, { once: true }));
  if (dialog.returnValue !== "save") return;
  localStorage.removeItem(`ticker.${token}.draft.${name}`);
  // Whoever types fast has gone on before the dialog says that it is closed.
  const before = standing(name);
  undos.push({ submission: name, ruling: before.ruling, comment: before.comment });
  enqueue(name, before.ruling, text.value.trim());
}

function quoteFindings() {
  const text = $("#comment textarea");
  const found = [...document.querySelectorAll("main .finding .message")].map((one) => one.textContent.trim());
  text.value = [text.value.trim(), ...found].filter(Boolean).join("\n");
  text.focus();
}

const acts = {
  award: () => decide("awarded") && goOn(),
  notYet: () => decide("notYet") && goOn(),
  comment: editComment,
  quote: quoteFindings,
  undo,
  next: goOn,
  back: () => { const name = trail.pop(); if (name !== undefined) showSubmission(name, { isBack: true }); },
  summary: showSummary,
  help: () => $("#help").showModal(),
  find: () => { $("#find").focus(); $("#find").select(); },
  report: () => current !== null && window.open(`report?name=${encodeURIComponent(current)}`, "_blank", "noopener"),
};
const keys = {
  a: "award", n: "notYet", c: "comment", u: "undo", j: "next", k: "back", s: "summary", "?": "help",
  "/": "find", o: "report",
};

document.addEventListener("keydown", (event) => {
  if (event.target.matches("#comment textarea")) {
    memory.set(`draft.${current}`, event.target.value);
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) $("#comment button[value=save]").click();
    return;
  }
  if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector("dialog[open]")) return;
  if (event.target.matches("input, select, textarea")) return;
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
