// The class page (index.html) in a browser. TICKER_CLASS is the folder of a graded class.
import assert from "node:assert/strict";
import { after, before, beforeEach, test } from "node:test";
import { pathToFileURL } from "node:url";
import { join } from "node:path";
import { accessibilityFaults, launchBrowser, openPage, overflow } from "./harness.mjs";

const index = pathToFileURL(join(process.env.TICKER_CLASS, "index.html")).href;
const all = ["bump-inverted-u", "distributed-off-centre", "does-not-compile", "reference-bump", "two-versions"];

let browser;
let page;
let problems;
before(async () => {
  browser = await launchBrowser();
  ({ page, problems } = await openPage(browser, index));
});
beforeEach(() => page.getByRole("button", { name: "Show all" }).click());
after(async () => {
  await browser.close();
  assert.deepEqual(problems, []);
});

const names = () => page.locator("tbody tr:visible th a:not(.student)").allTextContents();

test("words in the search find submissions by any text and by finding", async () => {
  await page.keyboard.press("/");
  await page.keyboard.type("bump");
  assert.deepEqual(await names(), ["bump-inverted-u", "reference-bump"]);
  assert.equal(await page.getByRole("status").textContent(), "2 of 5 submissions");
  await page.getByLabel("Search").fill("build.failed");
  assert.deepEqual(await names(), ["does-not-compile"]);
  await page.getByRole("button", { name: "Show all" }).click();
  assert.deepEqual(await names(), all);
});

test("the search does not look through words that stand in every row", async () => {
  await page.getByLabel("Search").fill("for the student");
  assert.deepEqual(await names(), []);
});

test("verdicts and findings filter, by list and by button, and together", async () => {
  await page.getByLabel("Verdict").selectOption("notAwarded");
  assert.deepEqual(await names(), ["bump-inverted-u", "distributed-off-centre", "does-not-compile"]);
  const verdict = page.locator("button[data-verdict=notAwarded]");
  assert.equal(await verdict.getAttribute("aria-pressed"), "true");
  const finding = page.getByRole("button", { name: "1 of 5 inverted the bumps along u" });
  await finding.click();
  assert.deepEqual(await names(), ["bump-inverted-u"]);
  assert.equal(await page.getByLabel("Finding").inputValue(), "bump.inverted-u");
  await finding.click();
  await verdict.click();
  assert.deepEqual(await names(), all);
});

test("headings sort both ways", async () => {
  const heading = page.getByRole("columnheader", { name: "Submission" });
  await heading.getByRole("button").click();
  assert.equal(await heading.getAttribute("aria-sort"), "ascending");
  assert.deepEqual(await names(), all);
  await page.keyboard.press("Enter");
  assert.equal(await heading.getAttribute("aria-sort"), "descending");
  assert.deepEqual(await names(), [...all].reverse());
  await page.getByRole("columnheader", { name: "Verdict" }).getByRole("button").click();
  assert.equal((await names())[0], "reference-bump");
  assert.equal(await heading.getAttribute("aria-sort"), null);
});

test("coming back from a report finds the filters as they were", async () => {
  await page.getByLabel("Verdict").selectOption("needsReview");
  await page.getByRole("link", { name: "two-versions", exact: true }).click();
  await page.waitForURL(/two-versions\/report\.html/);
  await page.goBack();
  await page.waitForURL(/index\.html/);
  assert.deepEqual(await names(), ["two-versions"]);
  assert.equal(await page.getByLabel("Verdict").inputValue(), "needsReview");
});

test("the page is whole, accessible, and fits a telephone", async () => {
  for (const image of await page.locator("td img").all())
    await image.evaluate((each) => { each.loading = "eager"; return each.decode(); });
  assert.deepEqual(await accessibilityFaults(page), []);
  await page.setViewportSize({ width: 360, height: 740 });
  assert.equal(await overflow(page), 0, "only the table may scroll sideways");
  const caption = await page.locator("caption").boundingBox();
  assert.ok(caption.x + caption.width <= 360, "its caption does not");
});
