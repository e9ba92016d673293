// What every test in a browser needs: Chromium, pages whose errors are recorded, and the accessibility checker axe.
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

const axeFile = createRequire(import.meta.url).resolve("axe-core/axe.min.js");

const switches = [
  "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync",
];

/// Starts Chromium with a profile of its own; `close` ends it and takes the profile away.
///
/// settings: what else Playwright's context has, such as a timezoneId.
export async function launchBrowser(settings = {}) {
  const profile = await mkdtemp(join(tmpdir(), "ticker-browser-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.TICKER_CHROMIUM || "/usr/bin/chromium",
    headless: true,
    chromiumSandbox: process.getuid() !== 0, // Chromium refuses its sandbox to root
    args: switches,
    viewport: { width: 1280, height: 900 },
    timeout: 120_000, // the first start on a machine reads some 350 MB from its disk
    ...settings,
  });
  context.setDefaultTimeout(60_000);
  return {
    context,
    close: async () => {
      await context.close();
      await rm(profile, { recursive: true, force: true });
    },
  };
}

/// Opens a page. Returns it with `problems`, a list that grows with every console error or warning, error of
/// a script, request to an address that is not allowed, and request that fails.
///
/// options: colorScheme "light" | "dark", width, height, media "screen" | "print"; `allowed`, a function that
/// returns whether the page may request an address (by default files, data and about: alone);
/// `expectRefusals`, true where the test provokes the page's security policy, whose messages then do not count.
export async function openPage(browser, url, options = {}) {
  const allowed = options.allowed || ((address) => /^(file|data|about):/.test(address));
  const page = await browser.context.newPage();
  const problems = [];
  page.on("console", (message) => {
    const refusal = options.expectRefusals && message.text().includes("Content Security Policy");
    if (["error", "warning"].includes(message.type()) && !refusal)
      problems.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => problems.push(`script: ${error.message}`));
  page.on("dialog", (dialog) => { // what a student wrote as a script opens one
    problems.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  page.on("request", (request) => {
    if (!allowed(request.url())) problems.push(`request: ${request.url()}`);
  });
  page.on("requestfailed", (request) => {
    const { errorText } = request.failure();
    // ERR_ABORTED: a picture was still loading when the test went to another page.
    if (errorText !== "net::ERR_ABORTED") problems.push(`missing: ${request.url()}: ${errorText}`);
  });
  await page.emulateMedia({
    colorScheme: options.colorScheme || "light", media: options.media || "screen",
    reducedMotion: "reduce", // no smooth scrolling: an element's place must not depend on the moment of measuring
  });
  await page.setViewportSize({ width: options.width || 1280, height: options.height || 900 });
  await page.goto(url, { waitUntil: "load" });
  return { page, problems };
}

/// What axe finds in a page against WCAG 2.2 AA and its own best practices, and in its contrast in dark
/// mode: one line for each kind of fault, with the first three elements that have it. Leaves the page in
/// dark mode.
export async function accessibilityFaults(page) {
  // Not by a script element: the pages' Content-Security-Policy blocks it.
  await page.evaluate(await readFile(axeFile, "utf8"));
  const faults = [];
  for (const [colorScheme, runOnly] of [
    ["light", ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]],
    ["dark", { type: "rule", values: ["color-contrast"] }],
  ]) {
    await page.emulateMedia({ colorScheme });
    const results = await page.evaluate((only) => globalThis.axe.run(document, {
      runOnly: only, resultTypes: ["violations"],
      rules: { "label-content-name-mismatch": { enabled: true } }, // of WCAG 2.1 A, but off by itself
    }), runOnly);
    for (const { id, help, nodes } of results.violations)
      faults.push(`${colorScheme}: ${id}: ${help}: ` +
        nodes.slice(0, 3).map(({ html }) => html.slice(0, 120)).join(" | "));
  }
  return faults;
}

/// By how many pixels a page is wider than its window.
export function overflow(page) {
  return page.evaluate(() =>
    document.documentElement.scrollWidth - document.documentElement.clientWidth);
}
