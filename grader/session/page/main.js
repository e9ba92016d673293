// The page of a ticking session: buttons, keys and start.
import { $, wait } from "./dom.js";
import { codeKey, nextMarkedLine, watchCode } from "./code.js";
import { editComment, watchComments } from "./comment.js";
import { decide, undo, watchDecisions } from "./decide.js";
import { watchGroups } from "./groups.js";
import { countText, filterForAddress, filterFrom, nextUndecided, setFilter, showRow, watchList } from "./list.js";
import { entries, flush, loadClass, model, waiting, watch } from "./model.js";
import { connection } from "./server.js";
import { goOn, viewers, watchSubmission } from "./submission.js";
import { watchSummary, wholeList } from "./summary.js";
import { canUndo } from "./undo.js";
import { viewerInSight } from "./viewer.js";
import { canGoBack, describeAddress, goBack, onOpen, open, viewName, writeAddress } from "./views.js";

const refreshMs = 1000;

// --- the frame of the page -----------------------------------------------------------------------

function showState() {
  const state = $(".state");
  const count = waiting();
  const text = connection.isOnline
    ? count ? `saving ${count} ...` : "all saved"
    : `the session does not answer; ${count} ${count === 1 ? "decision waits" : "decisions wait"} in this browser`;
  if (state.textContent !== text) state.textContent = text;
  state.classList.toggle("trouble", !connection.isOnline);
}

function showCounts() {
  const { done, text } = countText();
  const progress = $(".progress");
  progress.setAttribute("aria-valuemax", model.names.length);
  progress.setAttribute("aria-valuenow", done);
  $(".bar", progress).style.inlineSize = `${model.names.length ? (100 * done) / model.names.length : 0}%`;
  if ($(".count", progress).textContent !== text) $(".count", progress).textContent = text;
  showState();
}

/// Disables buttons that would do nothing.
function showButtons() {
  const isOne = model.current !== null;
  const can = {
    award: isOne || viewName() === "sheet", notYet: isOne || viewName() === "sheet", comment: isOne,
    undo: canUndo(), back: canGoBack(), next: isOne || nextUndecided() !== null,
  };
  for (const [act, is] of Object.entries(can)) $(`.buttons [data-act=${act}]`).disabled = !is;
}

const toggleList = (isOpen) => {
  $(".class").classList.toggle("open", isOpen);
  $("[data-act=list]").setAttribute("aria-expanded", String($(".class").classList.contains("open")));
};

// --- buttons and keys ----------------------------------------------------------------------------

const decisive = new Set(["award", "notYet", "undo"]); // a key that is held down does these once
const acts = {
  award: () => decide("awarded"),
  notYet: () => decide("notYet"),
  comment: editComment,
  undo,
  next: goOn,
  back: goBack,
  summary: () => open("summary"),
  groups: () => open("groups"),
  sheet: () => open("sheet"),
  line: nextMarkedLine,
  earlier: () => $("#earlier h2").focus(),
  wholeList,
  list: () => toggleList(),
  help: () => { $("#help").showModal(); $("#help").scrollTop = 0; }, // its only button is at its end
  find: () => { toggleList(true); $("#find").focus(); $("#find").select(); },
  report: () => model.current !== null && window.open(`of/${encodeURIComponent(model.current)}/report.html`, "_blank", "noopener"),
};
const keys = {
  a: "award", n: "notYet", c: "comment", u: "undo", j: "next", k: "back", s: "summary", g: "groups", v: "sheet", l: "line",
  "?": "help", "/": "find", o: "report",
};

document.addEventListener("keydown", (event) => {
  if (event.target.matches("dialog textarea")) {
    // Enter makes a new line in a comment, and submits a reason, which has one line.
    const isEnd = event.key === "Enter" && (event.target.id === "ask-why" || event.ctrlKey || event.metaKey);
    if (isEnd) event.preventDefault();
    if (isEnd) $("button[value=save]", event.target.form).click();
    return;
  }
  if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector("dialog[open]")) return;
  // Letter keys also work while a filter or a slider has the focus.
  if (event.target.matches("input:not([type=range], [type=checkbox])")) return;
  const look = { b: "blink", "+": "in", "=": "in", "-": "out" }[event.key];
  if (look && model.current !== null && viewers.length > 0) viewerInSight(viewers).act(look);
  if (codeKey(event)) return event.preventDefault();
  const act = keys[event.key];
  if (!act) return;
  event.preventDefault();
  if (!event.repeat || !decisive.has(act)) acts[act]();
});
document.addEventListener("click", (event) => {
  const act = event.target.closest("[data-act]")?.dataset.act;
  if (act && acts[act]) acts[act]();
});

// --- start ---------------------------------------------------------------------------------------

function openFromAddress() {
  const address = new URLSearchParams(location.hash.slice(1));
  setFilter(filterFrom(address));
  const [name, view] = [address.get("at"), address.get("view")];
  if (entries.has(name)) open("submission", { name });
  else if (["groups", "sheet", "summary"].includes(view)) open(view);
  else goOn();
}

async function begin() {
  describeAddress(filterForAddress);
  watchList();
  watchSubmission();
  watchCode();
  watchComments();
  watchDecisions();
  watchGroups();
  watchSummary();
  watch(() => { showCounts(); showButtons(); });
  connection.whenChanged = showState;
  onOpen((before) => {
    for (const name of [before, model.current]) if (name !== null) showRow(name);
    toggleList(false);
    showButtons();
  });
  await loadClass();
  flush();
  openFromAddress();
  // Links within the page, such as that to the submission, lead to a name without "=".
  window.addEventListener("hashchange", () => (location.hash.includes("=") ? openFromAddress() : writeAddress()));
  for (;;) {
    await wait(refreshMs);
    if (document.visibilityState === "visible") await loadClass();
  }
}
begin();
