// The student's code: marked lines, comments on lines, and keys that move between them.
import { $, make } from "./dom.js";
import { model, standing, watch } from "./model.js";
import { editNote, showMarkdown } from "./comment.js";

const lineOf = (place) => place?.closest?.(".code .line");
const fileOf = (line) => line.closest(".code").dataset.file;
const lines = () => [...document.querySelectorAll("main .code .line")];
const wordsOf = (line) => [...line.childNodes].filter((node) => !(node.classList?.contains("at") || node.classList?.contains("said")))
  .map((node) => node.textContent).join("").replace(/\n$/, "");

/// Shows the comments on lines below their lines.
export function codeChanged() {
  for (const old of document.querySelectorAll("main .said.note")) old.remove();
  for (const line of document.querySelectorAll("main .line.noted")) line.classList.remove("noted");
  if (model.current === null) return;
  for (const note of standing(model.current).notes) {
    const line = lines().find((one) => one.dataset.line === String(note.line) && fileOf(one) === note.file);
    if (!line) continue;
    line.classList.add("noted");
    const said = make("span", { class: "said note words" }, note.text);
    line.append(said);
    showMarkdown(said, note.text);
  }
}

/// Moves the focus to a line's button, so that Enter comments on the line.
function visit(line) {
  for (const other of document.querySelectorAll("main .code .at[tabindex='0']")) other.tabIndex = -1;
  const at = $(".at", line);
  at.tabIndex = 0;
  at.focus({ preventScroll: true });
  const pre = line.closest(".code");
  pre.scrollTop += line.getBoundingClientRect().top - pre.getBoundingClientRect().top - pre.clientHeight / 3;
  line.scrollIntoView({ block: "nearest", inline: "nearest" });
}

/// Moves to the next marked line; without marked lines, to the first line of the task.
export function nextMarkedLine() {
  const all = lines();
  if (all.length === 0) return;
  const from = all.indexOf(lineOf(document.activeElement));
  const isMarked = (line) => line.matches(".error, .warning, .proven, .noted");
  const following = [...all.slice(from + 1), ...all.slice(0, from + 1)];
  const task = all.findIndex((line) => $("i.m", line));
  visit(following.find(isMarked) ?? all[Math.max(from, task, 0)]);
}

/// After a submission was loaded: scrolls each file to its first marked line.
export function dressCode() {
  codeChanged();
  for (const pre of document.querySelectorAll("main .code")) {
    const first = $(".line.error, .line.proven, .line.noted", pre);
    if (first) pre.scrollTop = first.getBoundingClientRect().top - pre.getBoundingClientRect().top - pre.clientHeight / 3;
  }
}

function comment(line) {
  editNote({ file: fileOf(line), line: Number(line.dataset.line), code: wordsOf(line) });
}

/// Arrow keys move from line to line. Returns true if the key was one of these.
export function codeKey(event) {
  const line = lineOf(event.target) ?? (event.target.matches?.(".code") ? $(".line", event.target) : null);
  const step = { ArrowDown: 1, ArrowUp: -1, PageDown: 12, PageUp: -12 }[event.key];
  if (!line || !step) return false;
  const all = [...line.closest(".code").querySelectorAll(".line")];
  const from = lineOf(event.target) ? all.indexOf(line) : -1;
  visit(all[Math.min(Math.max(from + step, 0), all.length - 1)]);
  return true;
}

export function watchCode() {
  $("main").addEventListener("click", (event) => {
    const at = event.target.closest(".code .at");
    if (at) comment(lineOf(at));
  });
  watch((names) => {
    if (model.current !== null && $("main").dataset.name === model.current && (names ?? []).includes(model.current)) codeChanged();
  });
}
