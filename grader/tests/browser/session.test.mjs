// The ticking session in a browser. TICKER is the program, TICKER_CLASS a graded class, whose
// results are copied under new names into larger classes.
import assert from "node:assert/strict";
import { copyFileSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { accessibilityFaults, launchBrowser } from "./harness.mjs";
import {
  decide, gradeAgain, isSlowRun, killSessions, makeClass, openSession, otherFiles, saved, showing, shown, startSession,
} from "./session.mjs";

let browser;
before(async () => { browser = await launchBrowser(); });
after(async () => {
  await browser.close();
  killSessions();
});

/// The newest ruling of each decided submission by name, as the session returns it.
async function rulings(session) {
  const { submissions } = await (await fetch(`${session.address}class`)).json();
  return Object.fromEntries(submissions.filter((one) => one.decision).map((one) => [one.name, one.decision.ruling]));
}

test("the page is quiet, accessible and shows pictures, findings and code", async () => {
  const session = await startSession(makeClass(5));
  const { page, problems } = await openSession(browser, session);
  assert.equal(await shown(page), "=1+1_1002");
  await page.locator(".list button", { hasText: "Jürgen, jr_1000" }).click();
  assert.equal(await shown(page, "=1+1_1002"), "Jürgen, jr_1000");
  await page.locator("main").getByText("bump.inverted-u").first().waitFor();
  for (const image of await page.locator("main img").all())
    await image.evaluate((each) => { each.loading = "eager"; return each.decode(); });
  assert.ok((await page.locator("main img").count()) >= 2);
  assert.ok((await page.locator(".code i.k").count()) > 10);
  await page.keyboard.press("b");
  await page.keyboard.press("+");
  assert.equal(await page.locator(".viewer .showing").first().textContent(), "Showing: submitted");
  assert.equal(await page.locator(".viewer output").first().textContent(), "2×");
  await page.locator(".viewer [data-act=side]").first().click();
  assert.deepEqual(await accessibilityFaults(page), []);
  assert.deepEqual(problems, []);
  await page.close();
});

test("many decisions by keyboard, the session killed in between, none lost", async (t) => {
  const count = isSlowRun ? 100 : 40;
  const [killedAt, killedAndClosedAt] = [0.3 * count, 0.7 * count];
  const out = makeClass(count);
  let session = await startSession(out);
  let { page } = await openSession(browser, session);
  await page.getByLabel("You are").fill("ann");
  await page.locator("main").focus();
  const meant = {};
  let name;
  for (let i = 0; i < count; ++i) {
    name = await shown(page, name);
    const key = i % 3 === 0 ? "n" : "a";
    meant[name] = key === "a" ? "awarded" : "notYet";
    if (i === killedAt) {
      await session.kill();
      await decide(page, key); // waits in the browser for a session
      session = await startSession(out);
    } else if (i === killedAndClosedAt) {
      await session.kill();
      await decide(page, key);
      await page.close(); // now only the browser's storage has that decision
      session = await startSession(out);
      ({ page } = await openSession(browser, session));
      name = undefined; // the new page may begin with any submission
    } else {
      await decide(page, key);
    }
  }
  await page.getByRole("heading", { name: "All are decided" }).waitFor();
  await saved(page);
  await session.kill();
  const found = await rulings(await startSession(out));
  assert.deepEqual(found, meant);
  t.diagnostic(`${Object.keys(found).length} decisions on disk`);
  await page.close();
});

const many = isSlowRun ? 1000 : 250;
test(`${many} submissions load`, async (t) => {
  const session = await startSession(makeClass(many));
  const start = performance.now();
  const { page, problems } = await openSession(browser, session);
  await shown(page);
  assert.equal(await page.locator(".list li").count(), many);
  t.diagnostic(`${many} submissions: ${Math.round(performance.now() - start)} ms to the first one on the page`);
  assert.deepEqual(problems, []);
  await page.close();
});

test("two tickers at once lose nothing and see each other", async () => {
  const session = await startSession(makeClass(5));
  const [ann, bob] = [await openSession(browser, session), await openSession(browser, session)];
  for (const [{ page }, who] of [[ann, "ann"], [bob, "bob"]]) {
    await page.getByLabel("You are").fill(who);
    await shown(page);
    if (who === "bob") await page.route(/\/class\?/, () => {}); // bob's page gets no news of ann's decisions
    await page.locator("main").focus();
  }
  await decide(ann.page, "a");
  await saved(ann.page);
  await bob.page.keyboard.press("n");
  const dialog = bob.page.getByRole("dialog", { name: "Another ticker was faster" });
  assert.match(await dialog.locator(".words").textContent(), /ann decided about =1\+1_1002 meanwhile: awarded.*You said: not yet/);
  await dialog.getByRole("button", { name: "Put mine over it" }).click();
  await saved(bob.page);
  assert.equal((await rulings(session))["=1+1_1002"], "notYet");
  const reply = await (await fetch(`${session.address}submission?name=${encodeURIComponent("=1+1_1002")}`)).json();
  assert.deepEqual(reply.history.map(({ who, ruling }) => [who, ruling]), [["ann", "awarded"], ["bob", "notYet"]]);
  await ann.page.locator(".list li[data-ruling=notYet]").waitFor(); // ann's page learns of it by itself
  for (const { page } of [ann, bob]) await page.close();
});

test("comment, undo, search and summary", async () => {
  const session = await startSession(makeClass(5));
  const { page, problems } = await openSession(browser, session);
  const first = await shown(page);
  await page.getByLabel("You are").fill("ann");
  await page.locator("main").focus();
  await page.keyboard.press("c");
  await page.keyboard.type("See line 7.");
  await page.evaluate(() => { // as fast as keys can come: nothing of it may be lost
    const press = (target, options) => target.dispatchEvent(new KeyboardEvent("keydown", { bubbles: true, ...options }));
    press(document.querySelector("#comment textarea"), { key: "Enter", ctrlKey: true });
    press(document.body, { key: "a" });
  });
  const second = await shown(page, first);
  await page.keyboard.press("n");
  await shown(page, second);
  await page.keyboard.press("u");
  await page.waitForFunction((name) => document.querySelector("main").dataset.name === name, second);
  await saved(page);
  assert.deepEqual(await rulings(session), { [first]: "awarded", [second]: "undecided" });

  await page.keyboard.press("/");
  await page.keyboard.type("bump.inverted-u");
  assert.deepEqual(await page.locator(".list li:visible .name").allTextContents(), ["Jürgen, jr_1000"]);
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector("main").dataset.name === "Jürgen, jr_1000");
  await page.locator("main").focus();
  await page.keyboard.press("s");
  await page.getByRole("cell", { name: /See line 7\./ }).waitFor(); // against the proposal, and why
  assert.deepEqual(await accessibilityFaults(page), []);
  assert.deepEqual(problems, []);
  await page.close();
});

/// Queues decisions as the page does: [[index, ruling, comment, notes], ...].
const enqueue = (page, items) => page.evaluate(async (all) => {
  const { enqueue, model } = await import("./model.js");
  enqueue(all.map(([i, ruling, comment, notes = []]) => ({ submission: model.names[i], ruling, comment, notes, bulk: "" })), "ann");
}, items);

test("long comments in a script of several bytes a letter are stored for many at once", async () => {
  const count = 201;
  const session = await startSession(makeClass(count));
  const { page } = await openSession(browser, session);
  await shown(page);
  await enqueue(page, Array.from({ length: count }, (_, i) => [i, "notYet", "张".repeat(700)]));
  await saved(page);
  assert.equal(Object.values(await rulings(session)).filter((ruling) => ruling === "notYet").length, count);
  await page.close();
});

test("of decisions that are sent together only one that is too long is refused, and its words stay", async () => {
  const session = await startSession(makeClass(5));
  const { page } = await openSession(browser, session);
  await shown(page);
  const told = [];
  page.on("dialog", (dialog) => told.push(dialog.message())); // `openPage` closes it
  const words = "张".repeat(5000);
  const notes = [{ file: "BumpySphere.cpp", line: 2, code: "//", text: "long ".repeat(1200) }];
  const far = Array.from({ length: 40 }, (_, i) => ({ file: "BumpySphere.cpp", line: i + 1, code: "//", text: words.slice(0, 2000) }));
  await enqueue(page, [[0, "awarded", "fine"], [1, "awarded", words, notes], [2, "notYet", ""], [3, "notYet", "", far], [1, "notYet", "short"]]);
  await saved(page);
  const names = await page.locator(".list li .name").allTextContents();
  assert.deepEqual(await rulings(session), { [names[0]]: "awarded", [names[1]]: "notYet", [names[2]]: "notYet" });
  assert.equal(told.length, 1);
  assert.match(told[0], /^Not kept:\nJürgen, jr_1000: .* have 21000 bytes together, and 20000 are the most; shorten them\.\n.*_100\d: Its comments are too long/);
  assert.equal(await page.locator("#conflict[open]").count(), 0, "nobody else has decided");
  await page.getByLabel("You are").fill("ann");
  await page.locator(".list button", { hasText: names[1] }).click();
  await showing(page, names[1]);
  await page.locator("main").focus();
  await page.keyboard.press("c");
  assert.equal(await page.locator("#comment textarea").inputValue(), words);
  await page.close();
});

test("the link to the submission keeps the place and the filters", async () => {
  const session = await startSession(makeClass(20));
  const { page, problems } = await openSession(browser, session, { hash: "#find=inverted-u" });
  const first = await shown(page);
  await page.locator("main").focus();
  await page.keyboard.press("j");
  const second = await shown(page, first);
  const address = await page.evaluate(() => location.hash);
  await page.locator(".skip").focus();
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.activeElement.id === "submission" && location.hash !== "#submission");
  assert.equal(await shown(page), second);
  assert.equal(await page.locator("#find").inputValue(), "inverted-u");
  assert.equal(await page.evaluate(() => location.hash), address);
  assert.deepEqual(problems, []);
  await page.close();
});

test("a decision is about the files that were shown, and the footer tells of a later hand-in", async () => {
  const out = makeClass(2);
  const session = await startSession(out);
  const { page, problems } = await openSession(browser, session);
  await page.getByLabel("You are").fill("ann");
  const name = await shown(page);
  await page.locator("main").focus();
  gradeAgain(out, name, otherFiles);
  await page.locator(".standing", { hasText: "handed in again" }).waitFor();
  await decide(page, "n");
  await saved(page);
  const row = page.locator(".list button", { hasText: name });
  await row.filter({ hasText: "changed since decided" }).waitFor();
  await row.click();
  await showing(page, name);
  assert.doesNotMatch(await page.locator(".standing").textContent(), /handed in again/);
  assert.deepEqual(problems, []);
  await page.close();
});

/// Opens the class as a ticker of this name, at its first undecided submission.
async function openAs(session, who) {
  const { page, problems } = await openSession(browser, session);
  await page.getByLabel("You are").fill(who);
  const name = await shown(page);
  await page.locator("main").focus();
  return { page, problems, name };
}

const standing = (page) => page.locator(".standing").textContent();
const decisionOn = async (session, name) =>
  (await (await fetch(`${session.address}class`)).json()).submissions.find((one) => one.name === name).decision;

/// Writes a comment in the editor, for the student or on the line that has the focus.
async function comment(page, key, text) {
  await page.keyboard.press(key);
  await page.locator("#comment[open]").waitFor();
  await page.keyboard.type(text);
  await page.keyboard.press("Control+Enter");
}

test("a comment does not make a decision about an earlier hand-in one about the new files", async () => {
  const out = makeClass(2);
  const session = await startSession(out);
  const { page, problems, name } = await openAs(session, "ann");
  await decide(page, "n");
  await saved(page);
  const { files } = await decisionOn(session, name);
  gradeAgain(out, name, otherFiles);
  const row = page.locator(".list button", { hasText: name });
  await row.filter({ hasText: "changed since decided" }).waitFor();
  await row.click();
  await showing(page, name);
  await page.locator("main").focus();
  await comment(page, "c", "I will look on Monday.");
  await saved(page);
  assert.match(await standing(page), /other files than were decided about.*I will look on Monday/);
  assert.equal((await decisionOn(session, name)).files, files);
  await page.keyboard.press("u");
  await page.locator(".standing", { hasText: "comment taken back" }).waitFor();
  await saved(page);
  assert.match(await standing(page), /other files than were decided about/);
  assert.equal((await decisionOn(session, name)).files, files);
  await decide(page, "n"); // once more, about what is shown
  await saved(page);
  assert.equal((await decisionOn(session, name)).files, "other files");
  await page.keyboard.press("u");
  await showing(page, name);
  await saved(page);
  assert.equal((await decisionOn(session, name)).files, files);
  assert.deepEqual(problems, []);
  await session.kill("SIGTERM");
  assert.match(session.errors, new RegExp(`1 decision is about an earlier hand-in \\(${name}\\)`));
  assert.match(readFileSync(join(out, "index.html"), "utf8"), /decided: not yet, about an earlier hand-in</);
  await page.close();
});

test("words of another ticker that come while a dialog is open are not replaced unasked", async () => {
  const session = await startSession(makeClass(5));
  const [ann, bob] = [await openAs(session, "ann"), await openAs(session, "bob")];
  const { name } = ann;
  const conflict = ann.page.locator("#conflict[open]");
  await ann.page.keyboard.press("c");
  await comment(bob.page, "c", "from bob");
  await ann.page.locator(".standing", { hasText: "from bob" }).waitFor();
  await ann.page.keyboard.type("from ann");
  await ann.page.keyboard.press("Control+Enter");
  await conflict.waitFor();
  assert.match(await conflict.textContent(), /bob decided about .* meanwhile: undecided \(“from bob”\)\. You said: undecided \(“from ann”\)/);
  await conflict.getByRole("button", { name: "Keep theirs" }).click();
  await saved(ann.page);
  assert.equal((await decisionOn(session, name)).comment, "from bob");
  await ann.page.keyboard.press("c");
  assert.equal(await ann.page.locator("#comment textarea").inputValue(), "from ann", "not lost");
  await ann.page.keyboard.press("Escape");

  await ann.page.locator(".list button", { hasText: "Jürgen, jr_1000" }).click();
  const other = await shown(ann.page, name);
  await bob.page.locator(".list button", { hasText: other }).click();
  await showing(bob.page, other);
  await ann.page.locator("main").focus();
  await ann.page.keyboard.press("a");
  await ann.page.keyboard.type("at the desk");
  await bob.page.locator("main").focus();
  await bob.page.keyboard.press("l");
  await comment(bob.page, "Enter", "a sign");
  await ann.page.locator(".standing", { hasText: "commented by bob" }).waitFor();
  await ann.page.keyboard.press("Enter");
  await conflict.waitFor();
  assert.match(await conflict.textContent(), /bob decided about .* meanwhile: undecided, in line \d+ of BumpySphere\.cpp “a sign”\./);
  await conflict.getByRole("button", { name: "Put mine over it" }).click();
  await saved(ann.page);
  const { ruling, who, notes } = await decisionOn(session, other);
  assert.deepEqual([ruling, who, notes.map(({ text }) => text)], ["awarded", "ann", ["a sign"]]);
  for (const { page, problems } of [ann, bob]) { assert.deepEqual(problems, []); await page.close(); }
});

test("of several decisions that waited, the last is held against the other ticker's, and its words stay", async () => {
  const session = await startSession(makeClass(5));
  const [ann, bob] = [await openAs(session, "ann"), await openAs(session, "bob")];
  const { name, page } = ann;
  await page.route(/\/decide$/, (route) => route.abort());
  await decide(page, "n");
  await shown(page, name);
  await page.keyboard.press("k");
  await showing(page, name);
  await comment(page, "c", "What took ann long to write.");
  await page.locator(".state", { hasText: "2 decisions wait in this browser" }).waitFor();
  await decide(bob.page, "n");
  await saved(bob.page);
  await page.unroute(/\/decide$/);
  const conflict = page.locator("#conflict[open]");
  await conflict.waitFor();
  assert.match(await conflict.textContent(), /meanwhile: not yet\. You said: not yet \(“What took ann long to write\.”\)/);
  await conflict.getByRole("button", { name: "Keep theirs" }).click();
  await saved(page);
  assert.deepEqual([(await decisionOn(session, name)).who, (await decisionOn(session, name)).comment], ["bob", ""]);
  await page.keyboard.press("c");
  assert.equal(await page.locator("#comment textarea").inputValue(), "What took ann long to write.");
  for (const one of [ann, bob]) await one.page.close();
});

test("a key that is held down decides once", async () => {
  const session = await startSession(makeClass(5));
  const { page, name } = await openAs(session, "ann");
  await page.keyboard.down("n");
  const next = await shown(page, name);
  for (let i = 0; i < 5; ++i) await page.keyboard.down("n");
  await page.keyboard.up("n");
  await saved(page);
  assert.deepEqual(await rulings(session), { [name]: "notYet" });
  await page.keyboard.press("n");
  await shown(page, next);
  await page.keyboard.down("u");
  await showing(page, next);
  for (let i = 0; i < 5; ++i) await page.keyboard.down("u");
  await page.keyboard.up("u");
  await saved(page);
  assert.deepEqual(await rulings(session), { [name]: "notYet", [next]: "undecided" });
  await page.close();
});

test("a comment on a line is taken back after it was saved", async () => {
  const session = await startSession(makeClass(5));
  const { page, name } = await openAs(session, "ann");
  await page.keyboard.press("l");
  await comment(page, "Enter", "a sign");
  await saved(page);
  await page.locator("main").focus();
  await page.keyboard.press("u");
  await page.locator(".standing", { hasText: "line comment taken back" }).waitFor();
  await saved(page);
  assert.deepEqual((await decisionOn(session, name)).notes, []);
  await page.close();
});

test("a submission that is graded again can be loaded anew", async () => {
  const out = makeClass(5);
  const session = await startSession(out);
  const { page, problems, name } = await openAs(session, "ann");
  gradeAgain(out, name, () => ({ verdict: "needsReview" }));
  await page.locator(".standing", { hasText: "graded again" }).waitFor();
  await page.getByRole("button", { name: "Load it anew" }).click();
  await page.locator("main .chips .badge.needsReview").first().waitFor();
  await page.waitForFunction(() => !document.querySelector(".standing").textContent.includes("graded again"));
  assert.deepEqual(problems, []);
  await page.close();
});

test("the footer is not said again when another ticker decides about another submission", async () => {
  const session = await startSession(makeClass(5));
  const [ann, bob] = [await openAs(session, "ann"), await openAs(session, "bob")];
  await saved(ann.page);
  await bob.page.keyboard.press("j");
  const other = await shown(bob.page, bob.name);
  await ann.page.evaluate(() => {
    window.changes = 0;
    new MutationObserver((records) => { window.changes += records.length; })
      .observe(document.querySelector(".standing"), { childList: true, characterData: true, subtree: true });
  });
  await decide(bob.page, "n");
  await ann.page.locator(".list li[data-ruling=notYet]", { hasText: other }).waitFor();
  assert.equal(await ann.page.evaluate(() => window.changes), 0);
  for (const { page } of [ann, bob]) await page.close();
});

test("the summary follows what another ticker decides, and keeps the focus", async () => {
  const session = await startSession(makeClass(5));
  const [ann, bob] = [await openAs(session, "ann"), await openAs(session, "bob")];
  await ann.page.keyboard.press("s");
  const link = ann.page.locator("main table button", { hasText: "bump.inverted-u" });
  await link.focus();
  await decide(bob.page, "n");
  await saved(bob.page);
  await ann.page.locator("main .counts", { hasText: "0 awarded, 1 not yet, 4 undecided of 5." }).waitFor();
  await ann.page.getByRole("cell", { name: "bob" }).waitFor();
  assert.ok(await link.evaluate((one) => one === document.activeElement));
  for (const { page, problems } of [ann, bob]) { assert.deepEqual(problems, []); await page.close(); }
});

test("a second session over a class leaves the first one's address to it, and says so", async () => {
  const out = makeClass(2);
  const first = await startSession(out);
  const { port } = new URL(first.address);
  const second = await startSession(out);
  assert.notEqual(new URL(second.address).port, port);
  await second.kill("SIGTERM");
  assert.ok(second.errors.includes(first.address), second.errors);
  assert.match(second.errors, new RegExp(`--port ${port}\n`));
  await first.kill();
  assert.equal((await startSession(out)).address, first.address);
});

test("the full report shows the pictures that lie beside it", async () => {
  const out = makeClass(5);
  const session = await startSession(out);
  const { page, name } = await openAs(session, "ann");
  const [picture] = readdirSync(join(out, "Jürgen, jr_1000", "images"));
  const report = join(out, "Jürgen, jr_1000", "report.html");
  const address = `images/${encodeURIComponent(picture)}`;
  writeFileSync(report, readFileSync(report, "utf8").replace("</h1>", `</h1><img id="beside" src="${address}" alt="">`));
  await page.locator(".list button", { hasText: "Jürgen, jr_1000" }).click();
  await shown(page, name);
  await page.locator("main").focus();
  const opened = browser.context.waitForEvent("page");
  await page.keyboard.press("o");
  const shownReport = await opened;
  await shownReport.waitForLoadState();
  const image = shownReport.locator("#beside");
  await image.evaluate((one) => one.decode().catch(() => {}));
  assert.ok(await image.evaluate((one) => one.naturalWidth) > 0);
  assert.equal(await shownReport.evaluate(() => window.origin), "null", "and stays in its sandbox");
  await shownReport.close();
  await page.close();
});

test("drawings of submissions that are no longer shown are released", async () => {
  const session = await startSession(makeClass(40));
  const { page } = await openAs(session, "ann");
  const devtools = await page.context().newCDPSession(page);
  const canvases = async () => {
    const { result } = await devtools.send("Runtime.evaluate", { expression: "HTMLCanvasElement.prototype" });
    const { objects } = await devtools.send("Runtime.queryObjects", { prototypeObjectId: result.objectId });
    const { result: detached } = await devtools.send("Runtime.callFunctionOn", { objectId: objects.objectId,
      functionDeclaration: "function() { return this.filter((one) => !one.isConnected).length; }" });
    return detached.value;
  };
  const names = (await page.locator(".list li .name").allTextContents()).filter((name) => name.startsWith("Jürgen"));
  for (const name of names) {
    await page.locator(".list button", { hasText: name }).click();
    await showing(page, name);
    await page.locator(".ray-stage canvas").first().waitFor();
  }
  const each = await page.locator(".ray-figure canvas").count();
  assert.ok(each > 0);
  // What still goes on for the last ones holds theirs for some frames.
  let kept = await canvases();
  for (let frames = 0; frames < 100 && kept > 2 * each; ++frames) {
    await page.evaluate(() => new Promise(requestAnimationFrame));
    kept = await canvases();
  }
  assert.ok(kept <= 2 * each, `${kept} are kept of ${names.length} submissions`);
  await page.close();
});

test("a submission without a readable result gets a reason, and the class can be finished", async () => {
  const out = makeClass(5);
  const session = await startSession(out);
  const { page } = await openSession(browser, session);
  await shown(page);
  await page.getByLabel("You are").fill("ann");
  const file = (name) => join(out, name, "result.json");
  const open = (name) => page.locator(".list button", { hasText: name }).click();
  const reason = (text) => page.locator("main:not(.loading)", { hasText: text }).waitFor();
  const [removed, interrupted, damaged, graded] = ["Jürgen, jr_1000", "O'Neill #1? 100%_1001", "a&b;c_1004", "张 伟_1003"];
  renameSync(file(graded), `${file(graded)}.aside`); // as grading does for a moment
  await open(graded);
  await page.locator("main.loading").waitFor();
  renameSync(`${file(graded)}.aside`, file(graded));
  await showing(page, graded);
  await page.getByRole("heading", { name: graded }).waitFor();

  copyFileSync(file(interrupted), join(out, "aside.json"));
  rmSync(file(interrupted));
  writeFileSync(file(damaged), "{");
  await open(interrupted);
  await reason("It has no result.json");
  await open(damaged);
  await reason("It is damaged: result.json");
  await page.locator("main").focus();
  await decide(page, "n");
  copyFileSync(join(out, "aside.json"), file(interrupted));
  await open(interrupted);
  await page.getByRole("heading", { name: interrupted }).waitFor();
  rmSync(join(out, removed), { recursive: true });
  await page.waitForFunction(() => document.querySelectorAll(".list li").length === 4);
  await page.locator("main").focus();
  for (let name; await page.locator(".count").textContent() !== "4 of 4 decided";) {
    name = await shown(page, name);
    await decide(page, name === graded ? "a" : "n");
  }
  await page.getByRole("heading", { name: "All are decided" }).waitFor();
  await page.close();
});
