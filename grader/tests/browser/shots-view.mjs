// Makes the pictures of the viewer in docs/images, from a student's package with the model answer (view-kit.sh):
//   TICKER_VIEW_KIT=KIT node shots-view.mjs docs/images
import { join } from "node:path";
import { readFile, writeFile } from "node:fs/promises";
import { launchBrowser } from "./harness.mjs";
import { clickPixel, exerciseFile, finished, openViewer, startViewer } from "./viewer.mjs";

const images = process.argv[2];
const bumpFile = exerciseFile.replace("Renderer", "BumpySphere");
const lens = [exerciseFile, /randomBetween\(-settings\(\)\.dofAmount, /g, "randomBetween(0.0, 2.0 * "];

// name, scene, pixel as shares of width and height, colours, the highlighted line, clicks on "Nearer" (to the
// end of that line's ray), and perhaps an edit of a file: [file, from, to]
const shots = [
  ["view-shadow-edge", "distributed", 0.93, 0.855, "light", ".ray-camera", 0],
  ["view-out-of-focus", "distributed", 0.42, 0.55, "dark", ".ray-camera", 0],
  ["view-off-centre", "distributed", 0.5, 0.6, "light", ".ray-camera", 0, lens],
  ["view-inverted-bump", "bumpmap-test", 0.4297, 0.4396, "light", ".ray-camera", 9, [bumpFile, "- Bv", "+ Bv"]],
  ["view-blocked-reflection", "distributed", 0.45, 0.72, "light", ".ray-reflected", 5],
];

const browser = await launchBrowser();
for (const [name, scene, x, y, colorScheme, line, nearer, edit] of shots) {
  const source = edit && await readFile(edit[0], "utf8");
  if (edit) await writeFile(edit[0], source.replace(edit[1], edit[2]));
  const viewer = await startViewer(`scenes/${scene}.xml`, "-r", "320x240", "--seed", "1", ...(scene === "distributed" ? [] : ["--pinhole"]));
  try {
    const { page } = await openViewer(browser, viewer, { width: 1000, height: 900, colorScheme });
    await page.waitForFunction(() => ["Built.", "It does"].some((words) => document.getElementById("build").textContent.startsWith(words)));
    await page.waitForFunction(() => document.getElementById("tests").textContent && !document.getElementById("tests").textContent.includes("run ..."));
    await finished(page);
    await clickPixel(page, x, y);
    await page.locator(`.ray-list ${line}`).first().click();
    for (let i = 0; i < nearer; ++i) await page.getByRole("button", { name: "Nearer" }).click();
    await page.waitForTimeout(300);
    const path = join(images, `${name}.png`);
    await page.mouse.move(0, 0);
    if (name === "view-off-centre") await page.screenshot({ path, fullPage: true });
    else await page.locator("#rays").screenshot({ path }); // the picture above it is left out
    await page.close();
  } finally {
    await viewer.end("SIGTERM");
    if (edit) await writeFile(edit[0], source);
  }
}
await browser.close();
