// The ticking session as tickers meet it. TICKER is the program, TICKER_CLASS a graded class, whose
// results are copied under new names into larger classes.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { accessibilityFaults, launchBrowser } from "./harness.mjs";
import { isSlowRun, killSessions, makeClass, openSession, saved, shown, startSession } from "./session.mjs";

let browser;
before(async () => { browser = await launchBrowser(); });
after(async () => {
  await browser.close();
  killSessions();
});

/// Decides with a key, and says why where the page asks.
async function decide(page, key, why = "as shown at the desk") {
  await page.keyboard.press(key);
  if (await page.locator("#ask[open]").count() === 0) return;
  await page.keyboard.type(why);
  await page.keyboard.press("Enter");
}

/// What is on disk: the newest ruling by name.
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
  const [first, second] = [0.3 * count, 0.7 * count]; // when it is killed
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
    if (i === first || i === second) await session.kill();
    await decide(page, key); // this one waits in the browser
    if (i === second) await page.close(); // nothing but what the browser has stored is left
    if (i === first || i === second) session = await startSession(out);
    if (i === second) ({ page } = await openSession(browser, session));
    if (i === second) name = undefined;
  }
  await page.getByRole("heading", { name: "All are decided" }).waitFor();
  await saved(page);
  await session.kill();
  const found = await rulings(await startSession(out));
  assert.deepEqual(found, meant);
  t.diagnostic(`${Object.keys(found).length} decisions on disk`);
  await page.close();
});

test("1000 submissions load", async (t) => {
  const session = await startSession(makeClass(1000));
  const start = performance.now();
  const { page, problems } = await openSession(browser, session);
  await shown(page);
  assert.equal(await page.locator(".list li").count(), 1000);
  t.diagnostic(`1000 submissions: ${Math.round(performance.now() - start)} ms to the first one on the page`);
  assert.deepEqual(problems, []);
  await page.close();
});

test("two tickers at once lose nothing and see each other", async () => {
  const session = await startSession(makeClass(5));
  const [ann, bob] = [await openSession(browser, session), await openSession(browser, session)];
  for (const [{ page }, who] of [[ann, "ann"], [bob, "bob"]]) {
    await page.getByLabel("You are").fill(who);
    await shown(page);
    if (who === "bob") await page.route(/\/class\?/, () => {}); // never hears of ann
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
  await ann.page.locator(".list li[data-ruling=notYet]").waitFor(); // it is told, without being asked
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
