// Every view of the session and of the class page at 1280 and 420 pixels, light and dark, to be looked at:
//   TICKER=build/release/bin/ticker node shots-session.mjs OUT FOLDER
// OUT is a graded class without decisions; some are made here, in a copy of it. Prints what axe finds.
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { accessibilityFaults, launchBrowser, openPage, overflow } from "./harness.mjs";
import { killSessions, openSession, saved, shown, showing, startSession } from "./session.mjs";

const [from, folder] = process.argv.slice(2).map((path) => resolve(path));
const out = mkdtempSync(join(tmpdir(), "ticker-shots-"));
cpSync(from, out, { recursive: true });
mkdirSync(folder, { recursive: true });
const names = JSON.parse(process.env.TICKER_SHOTS || "null");

const browser = await launchBrowser();
const session = await startSession(out);
let faults = 0;

/// Pictures of one view: the window in light and dark mode, and the whole page. Then prints what axe finds.
async function shoot(page, name, width) {
  await page.mouse.move(0, 0);
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    await page.screenshot({ path: join(folder, `${name}-${width}-${colorScheme}.png`) });
  }
  await page.emulateMedia({ colorScheme: "light" });
  await page.screenshot({ path: join(folder, `${name}-${width}-whole.png`), fullPage: true });
  const found = await accessibilityFaults(page);
  if (await overflow(page) > 0) found.push("scrolls sideways");
  await page.emulateMedia({ colorScheme: "light" });
  for (const fault of found) console.log(`${name}-${width}: ${fault}`);
  faults += found.length;
}

const view = async (page, name) => {
  await page.evaluate((one) => { location.hash = `view=${one}`; }, name);
  await page.locator(`main[data-view=${name}]`).waitFor();
};
const at = async (page, name) => {
  await page.evaluate((one) => { location.hash = `at=${encodeURIComponent(one)}`; }, name);
  await showing(page, name);
  await page.waitForTimeout(300);
};

async function decideSome(page) {
  await page.locator("#who").fill("Ann");
  await page.locator("main").focus();
  for (let i = 0; i < 4; ++i) {
    const name = await shown(page);
    const verdict = await page.locator(".list [aria-current]").evaluate((button) => button.parentElement.dataset.verdict);
    await page.keyboard.press(verdict === "awarded" ? "a" : "n");
    await page.waitForFunction((last) => document.querySelector("main").dataset.name !== last, name);
  }
  await saved(page);
}

for (const width of [1280, 420]) {
  const { page, problems } = await openSession(browser, session, { width, height: width > 500 ? 900 : 850 });
  await shown(page);
  if (width === 1280) await decideSome(page);
  const all = await page.evaluate(async () => (await import("./model.js")).model.names);
  for (const name of names || all) { await at(page, name); await shoot(page, `submission-${name.replaceAll(/[^a-zA-Z0-9-]/g, "_")}`, width); }
  for (const one of ["groups", "sheet", "summary"]) {
    await view(page, one);
    if (one === "sheet") for (const card of await page.locator(".sheet-card").all()) await card.scrollIntoViewIfNeeded();
    await page.evaluate(() => window.scrollTo(0, 0));
    await page.waitForTimeout(300);
    await shoot(page, one, width);
  }
  await at(page, (names || all)[0]);
  if (width < 500) { await page.locator("[data-act=list]").first().click(); await shoot(page, "list", width); await page.locator("[data-act=list]").first().click(); }
  await page.locator("main").focus();
  await page.keyboard.press("c");
  await shoot(page, "comment", width);
  await page.keyboard.press("Escape");
  await page.keyboard.press("?");
  await shoot(page, "keys", width);
  await page.keyboard.press("Escape");
  if (problems.length > 0) console.log(problems.join("\n"));
  await page.close();
  for (const file of ["index.html", "similar.html"]) {
    const opened = await openPage(browser, pathToFileURL(join(out, file)).href, { width, height: 850 }).catch(() => null);
    if (!opened) continue;
    await shoot(opened.page, file.replace(".html", ""), width);
    await opened.page.close();
  }
}
console.log(`${faults} faults`);
await browser.close();
killSessions();
rmSync(out, { recursive: true, force: true });
