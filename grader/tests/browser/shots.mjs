// Makes the pictures of the pages in docs/images from the sample class:
//   ./tick demo && grader/tests/browser/install.sh build/shots &&
//   node build/shots/shots.mjs out/demo docs/images
import { pathToFileURL } from "node:url";
import { join, resolve } from "node:path";
import { launchBrowser, openPage } from "./harness.mjs";

const [out, images] = process.argv.slice(2).map((path) => resolve(path));

// name, page, height in pixels, colours
const shots = process.env.TICKER_DRAWINGS ? [] : [
  ["class", "index.html", 1000, "light"],
  ["report", "bump-inverted-u/report.html", 1300, "light"],
  ["report-student", "bump-inverted-u/student.html", 1100, "light"],
  ["report-passed", "reference-distributed/report.html", 1500, "light"],
  ["report-off-centre", "distributed-off-centre/report.html", 1500, "light"],
  ["report-compiler", "does-not-compile/report.html", 1100, "dark"],
];

// name, sample of the class, words of the drawing's caption
const drawings = [
  ["report-rays-shadow-edge", "distributed-near-half-of-the-light", "shadow rays"],
  ["report-rays-out-of-focus", "distributed-focus-along-ray", "rays of one pixel"],
  ["report-rays-inverted-bump", "bump-inverted-u", "normals"],
  ["report-rays-off-centre", "distributed-off-centre", "rays of one pixel"],
  ["report-rays-blocked", "distributed-any-hit-shadows", "shadow rays"],
];

const browser = await launchBrowser();
for (const [name, file, height, colorScheme] of shots) {
  const url = pathToFileURL(join(out, file)).href;
  const { page, problems } = await openPage(browser, url, { width: 1180, height, colorScheme });
  await page.screenshot({ path: join(images, `${name}.png`) });
  await page.close();
  if (problems.length > 0) throw new Error(`${file}: ${problems.join("; ")}`);
}
for (const [name, sample, words] of drawings) {
  const url = pathToFileURL(join(out, sample, "report.html")).href;
  const { page } = await openPage(browser, url, { width: 1000, height: 900 });
  const figure = page.locator(".ray-figure", { has: page.locator("figcaption", { hasText: words }) }).first();
  await figure.locator(".ray-stage canvas").scrollIntoViewIfNeeded();
  await page.waitForTimeout(300);
  await figure.screenshot({ path: join(images, `${name}.png`) });
  await page.close();
}
await browser.close();
