// Many submissions in the ticking session: groups, contact sheets, comments that tickers share, filters in
// the address, and the time that a large class takes. TICKER is the program, TICKER_CLASS a graded class
// (see session.mjs).
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, existsSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { join } from "node:path";
import { accessibilityFaults, launchBrowser, overflow } from "./harness.mjs";
import { isSlowRun, killSessions, makeClass, onDisk, openSession, saved, shown, showing, startSession, ticker } from "./session.mjs";

let browser;
before(async () => { browser = await launchBrowser(); });
after(async () => {
  await browser.close();
  killSessions();
});

const listed = (page) => page.locator(".list li:visible .name").allTextContents();

async function openAs(session, who, hash = "") {
  const { page, problems } = await openSession(browser, session, { hash });
  await page.locator("main[data-view]").waitFor();
  await page.getByLabel("You are").fill(who);
  await page.locator("main").focus();
  return { page, problems };
}

const inClass = async (session) => (await (await fetch(`${session.address}class`)).json()).submissions;

/// Scrolls every card of the contact sheet into view, and waits until the page counts all of them as looked at.
async function lookAtAll(page) {
  for (const card of await page.locator(".sheet-card").all()) await card.scrollIntoViewIfNeeded();
  await page.waitForFunction(() => !document.querySelector(".standing").textContent.includes("not looked at yet"));
}

test("a group is decided on its contact sheet, says so, and is taken back as one", async () => {
  const out = makeClass(60);
  const session = await startSession(out);
  const { page, problems } = await openAs(session, "ann");
  await page.keyboard.press("g");
  await page.getByRole("heading", { name: /^\d+ groups$/ }).waitFor();
  assert.deepEqual(await accessibilityFaults(page), []);
  await page.emulateMedia({ colorScheme: "light" });
  await page.getByRole("button", { name: "Contact sheet: bump.inverted-u" }).click();
  const members = await listed(page);
  assert.equal(members.length, 12);
  await page.locator("main").focus();
  await page.keyboard.press("n");
  assert.equal(await page.locator("dialog[open]").count(), 0, "not all of them were on the screen");
  await lookAtAll(page);
  assert.equal(await page.locator(".sheet-card figure img").count(), 2 * members.length, "expected beside submitted");
  await page.locator(".sheet-card input").first().uncheck();
  assert.deepEqual(await accessibilityFaults(page), []);
  await page.keyboard.press("n");
  await page.locator("#ask[open]").waitFor();
  assert.equal(await page.locator("#ask h2").textContent(), "“not yet” for 11 submissions?");
  await page.keyboard.type("One sign is wrong.");
  await page.keyboard.press("Enter");
  await saved(page);
  const rows = onDisk(out);
  for (const [name, { ruling, comment, decidedBy }] of Object.entries(rows))
    assert.deepEqual([ruling, comment, decidedBy],
      members.slice(1).includes(name) ? ["notYet", "One sign is wrong.", "ann"] : ["", "", ""], name);
  const bulks = new Set((await inClass(session)).map(({ decision }) => decision?.bulk ?? "").filter(Boolean));
  assert.equal(bulks.size, 1);
  await page.getByRole("button", { name: `Open ${members[1]}` }).click();
  await showing(page, members[1]);
  assert.match(await page.locator(".standing").textContent(), /in bulk, with 10 more/);
  await page.keyboard.press("u");
  await page.waitForFunction(() => document.querySelector(".count").textContent.startsWith("0 of"));
  await saved(page);
  assert.ok(Object.values(onDisk(out)).every(({ ruling, comment }) => ruling === "" && comment === ""));
  assert.deepEqual(problems, []);
  await page.close();
});

test("a bulk decision against the proposals asks why, and its words are kept beside each one's own", async () => {
  const out = makeClass(10);
  const session = await startSession(out);
  const { page } = await openAs(session, "ann", "#finding=bump.inverted-u&view=sheet");
  const [first, second] = await listed(page);
  await page.getByRole("button", { name: `Open ${first}` }).click();
  await showing(page, first);
  await page.keyboard.press("c");
  await page.keyboard.type("Your own words.");
  await page.keyboard.press("Control+Enter");
  await page.keyboard.press("v");
  await lookAtAll(page);
  await page.keyboard.press("a");
  await page.keyboard.press("Enter");
  assert.ok(await page.locator("#ask[open]").isVisible(), "a reason is asked for");
  await page.keyboard.type("shown at the desk");
  await page.keyboard.press("Enter");
  await saved(page);
  const rows = onDisk(out);
  assert.deepEqual([rows[first].ruling, rows[first].comment], ["awarded", "Your own words."]);
  assert.deepEqual([rows[second].ruling, rows[second].comment], ["awarded", "shown at the desk"]);
  await page.close();
});

test("a submission that comes leaves the contact sheet as it is, and is added to it", async () => {
  const out = makeClass(60);
  const session = await startSession(out);
  const { page, problems } = await openAs(session, "ann", "#finding=bump.inverted-u&view=sheet");
  await lookAtAll(page);
  const [first, second, ...rest] = await listed(page);
  const box = (name) => page.locator(".sheet-card", { hasText: name }).locator("input");
  for (const name of [first, second]) await box(name).uncheck();
  const last = page.locator(".sheet-card").last();
  await last.scrollIntoViewIfNeeded();
  const before = (await last.boundingBox()).y;
  const late = "Jürgen, jr_2000"; // the list's order has it last
  cpSync(join(out, first), join(out, late), { recursive: true });
  const file = join(out, late, "result.json");
  writeFileSync(file, JSON.stringify({ ...JSON.parse(readFileSync(file, "utf8")), submission: late }));
  execFileSync(ticker, ["collect", out, "--quiet"]);
  await page.locator(".sheet-card", { hasText: late }).waitFor();
  assert.deepEqual(await page.locator(".sheet-card label").allTextContents(), [first, second, ...rest, late].map((name) => ` ${name}`));
  for (const name of [first, second]) assert.ok(!await box(name).isChecked(), name);
  assert.ok(await box(late).isChecked());
  assert.equal((await page.locator(".sheet-card").nth(rest.length + 1).boundingBox()).y, before, "the page stays where it is");
  await lookAtAll(page);
  assert.equal(await page.locator(".sheet-card figure img").count(), 2 * (rest.length + 3));
  assert.deepEqual(problems, []);
  await page.close();
});

test("another ticker's decisions come to an open contact sheet and to the groups", async () => {
  const session = await startSession(makeClass(20));
  const hash = "#finding=bump.inverted-u";
  const ann = await openAs(session, "ann", `${hash}&view=sheet`);
  const cat = await openAs(session, "cat", `${hash}&view=groups`);
  const bob = await openAs(session, "bob", hash);
  const [first, second, third] = await listed(ann.page);
  const card = (name) => ann.page.locator(".sheet-card", { hasText: name });
  await card(third).locator("input").uncheck();
  await cat.page.getByText(/^4 submissions, 0 decided$/).waitFor();
  assert.equal(await shown(bob.page), first);
  await bob.page.keyboard.press("n");
  await card(first).locator(".badge", { hasText: "not yet" }).waitFor();
  const ticked = (name) => card(name).locator("input").isChecked();
  assert.deepEqual([await ticked(first), await ticked(second), await ticked(third)], [false, true, false]);
  await cat.page.getByText(/^4 submissions, 1 decided$/).waitFor();
  await bob.page.keyboard.press("u");
  await card(first).locator(".badge", { hasNotText: "not yet" }).waitFor();
  assert.equal(await ticked(first), false, "nothing is ticked unasked");
  for (const { page, problems } of [ann, bob, cat]) { assert.deepEqual(problems, []); await page.close(); }
});

test("saved words are offered to the other ticker, with the student's name", async () => {
  const session = await startSession(makeClass(20));
  const [ann, bob] = [await openAs(session, "ann", "#finding=bump.inverted-u"), await openAs(session, "bob", "#finding=bump.inverted-u")];
  await shown(ann.page);
  await ann.page.keyboard.press("c");
  await ann.page.keyboard.type("{name}: turn **one** sign.");
  await ann.page.locator("[data-act=keepWords]").click();
  await ann.page.getByText("Saved for the tickers of this class.").waitFor();
  await ann.page.keyboard.press("Escape");
  const name = await shown(bob.page);
  await bob.page.keyboard.press("j");
  const other = await shown(bob.page, name);
  await bob.page.waitForFunction(async () => (await (await fetch("class")).json()).comments.length === 1);
  for (;;) { // the page asks each second
    await bob.page.keyboard.press("c");
    if (await bob.page.locator("#comment .offer", { hasText: "turn **one** sign" }).count() > 0) break;
    await bob.page.keyboard.press("Escape");
  }
  await bob.page.locator("#comment .offer", { hasText: "saved by ann for bump.inverted-u" }).click();
  await bob.page.locator("#comment .preview strong").waitFor();
  assert.deepEqual(await accessibilityFaults(bob.page), []);
  await bob.page.keyboard.press("Control+Enter");
  await saved(bob.page);
  const { decision } = (await inClass(session)).find((one) => one.name === other);
  assert.equal(decision.comment, `${other.replace(/_\d+$/, "")}: turn **one** sign.`);
  for (const { page, problems } of [ann, bob]) { assert.deepEqual(problems, []); await page.close(); }
});

test("who is mended by the same edit is a group, and its line fills saved words", async () => {
  const repair = { task: "T1", finding: "bump.inverted-u", file: "BumpySphere.cpp", proven: true, next: "",
    line: 20, edit: { from: "    return normal + Bu;", to: "    return normal - Bu;" } };
  const session = await startSession(makeClass(20, [repair]));
  const { page, problems } = await openAs(session, "ann", "#view=groups");
  const cards = page.locator(".group", { hasText: "bump.inverted-u" });
  await cards.first().waitFor();
  assert.equal(await cards.count(), 2, "the same finding with and without that edit");
  const mended = cards.filter({ hasText: "return normal + Bu; → return normal - Bu;" });
  assert.match(await mended.textContent(), /2 submissions/);
  await mended.getByRole("button").click();
  await page.locator(".sheet-card").first().waitFor();
  const members = await listed(page);
  assert.equal(members.length, 2);
  await page.getByRole("button", { name: `Open ${members[0]}` }).click();
  await showing(page, members[0]);
  await page.keyboard.press("l");
  assert.equal(await page.evaluate(() => document.activeElement.closest(".line")?.dataset.line), "20");
  await page.keyboard.press("c");
  await page.keyboard.type("Write {to} for {from}.");
  await page.keyboard.press("Control+Enter");
  await saved(page);
  const { decision } = (await inClass(session)).find((one) => one.name === members[0]);
  assert.equal(decision.comment, "Write return normal - Bu; for return normal + Bu;.");
  assert.deepEqual(await accessibilityFaults(page), []);
  assert.deepEqual(problems, []);
  await page.close();
});

test("who shares code is a filter, and leads to the two files", async () => {
  const out = makeClass(10);
  const names = readdirSync(out).filter((name) => existsSync(join(out, name, "result.json")));
  const [left, right] = names;
  writeFileSync(join(out, "similar.json"), JSON.stringify([{ left, right, file: "BumpySphere.cpp", percent: 62 }]));
  writeFileSync(join(out, "similar.html"), "<!doctype html><title>Similar submissions</title>");
  const session = await startSession(out);
  const { page, problems } = await openAs(session, "ann", "#show=similar");
  assert.deepEqual((await listed(page)).sort(), [left, right].sort());
  const name = await shown(page);
  const other = name === left ? right : left;
  assert.match(await page.locator("main").textContent(), new RegExp("Shares code with .* \\(62 %\\)"));
  assert.ok((await page.locator("main").textContent()).includes(other));
  const [opened] = await Promise.all([page.context().waitForEvent("page"), page.getByRole("link", { name: "Compare the files" }).click()]);
  await opened.waitForLoadState();
  assert.equal(await opened.title(), "Similar submissions");
  assert.deepEqual(problems, []);
  await opened.close();
  await page.close(); // which would ask a session that has ended
  await session.kill("SIGTERM"); // which writes the students' pages
  for (const file of ["report", "student"])
    for (const each of names) {
      const html = existsSync(join(out, each, `${file}.html`)) ? readFileSync(join(out, each, `${file}.html`), "utf8") : "";
      assert.ok(!html.includes("Shares code"), "in no report");
    }
});

test("the address says what the list shows, in which order, and what fills the page", async () => {
  const session = await startSession(makeClass(20));
  const { page } = await openAs(session, "ann");
  await page.locator(".more summary").click();
  await page.locator("#task").selectOption("T1:failed");
  await page.locator("#finding").selectOption("bump.inverted-u");
  await page.locator("#sort").selectOption("finding");
  const found = await listed(page);
  assert.equal(found.length, 4);
  await page.keyboard.press("Tab");
  await page.locator("main").focus();
  await page.keyboard.press("j");
  const name = await shown(page);
  const other = await openSession(browser, session, { hash: await page.evaluate(() => location.hash) });
  await showing(other.page, name);
  assert.deepEqual(await listed(other.page), found);
  await page.keyboard.press("n");
  await saved(page);
  await other.page.close();
  await page.locator("#whole").click();
  await page.locator("#by").selectOption("ann");
  assert.deepEqual(await listed(page), [name]);
  await page.close();
});

/// The class page on disk as soon as it has this text, and after half a minute as it is: the session writes it anew
/// every few seconds.
async function classPageWith(page, out, text) {
  const deadline = Date.now() + 30_000;
  for (;;) {
    const html = readFileSync(join(out, "index.html"), "utf8");
    if (html.includes(text) || Date.now() >= deadline) return html;
    await page.waitForTimeout(200);
  }
}

test("the class page and the session show the same numbers after random decisions", async () => {
  const out = makeClass(40);
  const session = await startSession(out);
  const { page } = await openAs(session, "ann");
  let state = 7; // an explicit seed
  const random = (below) => { state = (state * 48271) % 2147483647; return state % below; };
  const rulings = ["awarded", "notYet", "undecided"];
  for (let round = 0; round < (isSlowRun ? 3 : 2); ++round) {
    const picks = Array.from({ length: 25 }, () => [random(40), rulings[random(3)]]);
    await page.evaluate(async (all) => {
      const { enqueue, model, waiting } = await import("./model.js");
      enqueue(all.map(([i, ruling]) => ({ submission: model.names[i], ruling, comment: "", notes: [], bulk: "" })), "ann");
      while (waiting() > 0) await new Promise((done) => setTimeout(done, 5));
    }, picks);
    await page.keyboard.press(round % 2 === 0 ? "g" : "v");
    await page.keyboard.press("s");
    const [decided, proposed] = await page.locator("main .counts").allTextContents();
    const found = await page.locator("main table", { hasText: "Most frequent findings" }).locator("tbody tr")
      .evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
    const html = await classPageWith(page, out, `>${decided}<`);
    assert.ok(html.includes(`<span id="decided">${decided}</span>`), decided);
    for (const [, count, word] of proposed.matchAll(/(\d+) ([a-z ]+)/g))
      assert.match(html, new RegExp(`<strong>${count}</strong> ${word.replace(/needs? a look/, "needs? a look")}<`));
    for (const [id, count] of found)
      assert.match(html, new RegExp(`data-finding="${id.replaceAll(".", "\\.")}"[^]{0,200}?<span class="count">${count} of 40</span>`), id);
  }
  await page.close();
});

const [size, atOnce, keys] = isSlowRun ? [500, 200, 20] : [150, 60, 4];
test(`${size} submissions: the page opens, keys go on, ${atOnce} decisions at once reach the other ticker`, async (t) => {
  const out = makeClass(size);
  const session = await startSession(out);
  const opened = await openAs(session, "ann");
  await opened.page.close(); // the browser has started, and the disk is warm
  const { page } = await openSession(browser, session);
  const name = await shown(page);
  const tookFirst = await page.evaluate(() => performance.getEntriesByName("first submission")[0].startTime);
  t.diagnostic(`${size} submissions: ${Math.round(tookFirst)} ms from the address to the first one on the page`);
  await page.locator("main").focus();
  const waits = [];
  let before = name;
  for (let i = 0; i < keys; ++i) {
    waits.push(await page.evaluate(() => new Promise((done) => {
      const main = document.querySelector("main");
      const from = performance.now();
      const was = main.dataset.name;
      new MutationObserver((_, observer) => {
        if (main.dataset.name === was) return;
        observer.disconnect();
        requestAnimationFrame(() => done(performance.now() - from));
      }).observe(main, { attributes: true });
      document.body.dispatchEvent(new KeyboardEvent("keydown", { key: "j", bubbles: true }));
    })));
    before = await shown(page);
    await page.waitForLoadState("networkidle");
  }
  waits.sort((one, other) => one - other);
  t.diagnostic(`a key: ${waits[keys / 2].toFixed(0)} ms in the middle, ${waits.at(-1).toFixed(0)} ms at most, until the next is on the page`);
  assert.ok(before);
  const bob = await openAs(session, "bob");
  const took = await page.evaluate(async (count) => {
    const { enqueue, waiting, model } = await import("./model.js");
    const from = performance.now();
    enqueue(model.names.slice(0, count).map((submission) => ({ submission, ruling: "notYet", comment: "as all", notes: [], bulk: "b" })), "ann");
    while (waiting() > 0) await new Promise((done) => setTimeout(done, 5));
    return performance.now() - from;
  }, atOnce);
  const from = performance.now();
  t.diagnostic(`${atOnce} at once: ${Math.round(took)} ms until they are on disk`);
  await bob.page.waitForFunction((count) => document.querySelector(".count").textContent.startsWith(`${count} of`), atOnce);
  t.diagnostic(`the other browser shows them ${Math.round(performance.now() - from)} ms later`);
  assert.equal(Object.values(onDisk(out)).filter(({ ruling }) => ruling === "notYet").length, atOnce);
  await page.close();
  await bob.page.close();
});

test("killed again and again while it decides, the session loses nothing", async () => {
  const count = isSlowRun ? 60 : 18;
  const out = makeClass(count);
  let session = await startSession(out);
  const { page } = await openAs(session, "ann");
  const meant = {};
  let name;
  for (let i = 0; i < count; ++i) {
    name = await shown(page, name);
    const verdict = await page.locator(".list [aria-current]").evaluate((button) => button.parentElement.dataset.verdict);
    meant[name] = verdict === "awarded" ? "awarded" : "notYet";
    await page.keyboard.press(verdict === "awarded" ? "a" : "n");
    if (i % 3 === 0) { await session.kill(); session = await startSession(out); }
  }
  await page.getByRole("heading", { name: "All are decided" }).waitFor();
  await saved(page);
  await session.kill();
  const found = await inClass(await startSession(out));
  assert.deepEqual(Object.fromEntries(found.map(({ name: one, decision }) => [one, decision.ruling])), meant);
  await page.close();
});

test("every view fits a phone, and its footer leaves room", async () => {
  const session = await startSession(makeClass(25));
  const { page } = await openSession(browser, session, { width: 420, height: 850 });
  await shown(page);
  assert.ok(await page.evaluate(() => document.querySelector(".decide").offsetHeight) <= 90);
  for (const view of ["groups", "sheet", "summary"]) {
    await page.evaluate((one) => { location.hash = `view=${one}`; }, view);
    await page.locator(`main[data-view=${view}]`).waitFor();
    assert.equal(await overflow(page), 0, view);
    assert.deepEqual(await accessibilityFaults(page), [], view);
  }
  await page.evaluate(() => { location.hash = "find=no-such-name&view=summary"; });
  await page.getByRole("heading", { name: "The list shows no submission" }).waitFor();
  await page.locator("[data-act=wholeList]").last().click();
  await shown(page);
  await page.locator("[data-act=list]").click();
  assert.ok(await page.locator(".list li:visible").count() >= 10);
  await page.locator(".list button").nth(2).click();
  await shown(page);
  assert.ok(await page.locator(".class").isHidden());
  assert.equal(await overflow(page), 0);
  for (const button of await page.locator(".decide button").all())
    assert.ok((await button.boundingBox()).height >= 44, "a thumb hits it");
  await page.close();
});
