// What tests of the ticking session share. TICKER is the program.
import { execFileSync, spawn } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { openPage } from "./harness.mjs";

export const ticker = process.env.TICKER;
/// Whether `./tick guard slow` runs the tests, which then try more cases.
export const isSlowRun = "TICKER_SLOW_TESTS" in process.env;
const sessions = [];
const folders = [];
const samples = ["bump-inverted-u", "distributed-off-centre", "does-not-compile", "reference-bump", "two-versions"];
const oddNames = ["Jürgen, jr", "O'Neill #1? 100%", "=1+1", "张 伟", "a&b;c"];

/// Starts a session and waits for its address. `errors` grows with what it prints on stderr.
export async function startSession(out) {
  const process = spawn(ticker, ["session", out, "--quiet"], { stdio: ["ignore", "pipe", "pipe"] });
  const session = {
    process, errors: "",
    kill: (signal = "SIGKILL") => new Promise((done) => { process.once("close", done); process.kill(signal); }),
  };
  process.stderr.setEncoding("utf8").on("data", (text) => { session.errors += text; console.error(text.trimEnd()); });
  const lines = createInterface({ input: process.stdout });
  session.address = await new Promise((done) => lines.once("line", done));
  sessions.push(session);
  return session;
}

/// Makes an OUT of `size` submissions: results of TICKER_CLASS under new names, taken into the store by
/// `ticker collect`, as on a cluster.
///
/// repairs: proven edits in the form of result.json, for every second copy of "bump-inverted-u".
export function makeClass(size, repairs = []) {
  const out = mkdtempSync(join(tmpdir(), "ticker-session-"));
  folders.push(out);
  for (let i = 0; i < size; ++i) {
    const sample = join(process.env.TICKER_CLASS, samples[i % samples.length]);
    const name = `${oddNames[i % oddNames.length]}_${1000 + i}`;
    const result = JSON.parse(readFileSync(join(sample, "result.json"), "utf8"));
    const isSmall = size <= 200; // tests of large classes do not look at pictures
    const without = isSmall ? {} : { renders: [], pictures: [] };
    const isMended = repairs.length > 0 && sample.endsWith("bump-inverted-u") && i % 2 === 0;
    const proven = isMended ? { repairs } : {};
    mkdirSync(join(out, name));
    writeFileSync(join(out, name, "result.json"), JSON.stringify({ ...result, ...without, submission: name, ...proven }));
    if (!isSmall) continue;
    for (const part of ["images", "code", "report.html"])
      cpSync(join(sample, part), join(out, name, part), { recursive: true });
  }
  execFileSync(ticker, ["collect", out, "--quiet"]);
  return out;
}

/// Replaces parts of a submission's result, {part: value} of the result so far, and takes it into the store.
export function gradeAgain(out, name, change) {
  const file = join(out, name, "result.json");
  const result = JSON.parse(readFileSync(file, "utf8"));
  writeFileSync(file, JSON.stringify({ ...result, ...change(result) }));
  execFileSync(ticker, ["collect", out, "--quiet"]);
}

/// A later hand-in, for `gradeAgain`.
export const otherFiles = ({ inputs }) => ({ inputs: { ...inputs, files: "other files" } });

/// Ends what `startSession` started, and removes what `makeClass` made.
export function killSessions() {
  for (const session of sessions) session.process.kill("SIGKILL");
  for (const folder of folders) rmSync(folder, { recursive: true, force: true });
}

/// options: those of `openPage`, and `hash`, which is added to the address.
export const openSession = (browser, session, options = {}) =>
  openPage(browser, session.address + (options.hash ?? ""), { allowed: (address) => address.startsWith(session.address), ...options });

/// Waits until a submission, not that named `other`, fills the page and can be decided. Returns its name.
export async function shown(page, other) {
  const main = page.locator("main[data-name]:not(.loading)");
  await page.waitForFunction((before) => {
    const main = document.querySelector("main[data-name]:not(.loading)");
    return main && main.dataset.name !== before;
  }, other);
  return main.getAttribute("data-name");
}

/// Waits until this submission fills the page.
export const showing = (page, name) => page.waitForFunction((wanted) =>
  document.querySelector("main[data-name]:not(.loading)")?.dataset.name === wanted, name);

/// Waits until the page reports that all is saved. A dialog's answer is taken in its close event, which the
/// browser has queued, not yet sent, when a key press returns: a timer that is queued after it runs after it.
export async function saved(page) {
  await page.evaluate(() => new Promise((done) => { setTimeout(done); }));
  await page.waitForFunction(() => document.querySelector(".state").textContent === "all saved");
}

/// Decides with a key, and types a reason where the page asks for one.
export async function decide(page, key, why = "as shown at the desk") {
  await page.keyboard.press(key);
  if (await page.locator("#ask[open]").count() === 0) return;
  await page.keyboard.type(why);
  await page.keyboard.press("Enter");
}

/// What another process finds on disk: the rows of the class's table by submission, {verdict, ruling,
/// decidedBy, decidedAt, comment, ...}.
export const onDisk = (out) =>
  rowsOf(execFileSync(ticker, ["report", out, "--format", "csv", "--quiet"], { encoding: "utf8" }));

/// The same rows from the text of a summary.csv.
export function rowsOf(csv) {
  const text = csv.replace(/^\uFEFF/, "");
  const rows = [];
  for (let row = [], at = 0; at < text.length;) {
    const [cell, plain, quoted, end] = /([^",\r\n]*)(?:"((?:[^"]|"")*)")?(,|\r\n|$)/y.exec(text.slice(at));
    row.push(quoted === undefined ? plain : quoted.replaceAll('""', '"'));
    at += cell.length;
    if (end !== ",") { rows.push(row); row = []; }
  }
  const [head, ...rest] = rows;
  return Object.fromEntries(rest.map((row) => [row[0], Object.fromEntries(head.map((key, i) => [key, row[i]]))]));
}
