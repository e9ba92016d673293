// Measures the viewer: `./tick bench view [--json FILE]`. TICKER_VIEW_KIT is a built package of a student with
// the model answer (view-kit.sh).
// Times are by the clock. The cost of rendering is in CPU time, which other programs change little.
import { spawnSync } from "node:child_process";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { writeFile } from "node:fs/promises";
import { join } from "node:path";
import { launchBrowser } from "./harness.mjs";
import { clickPixel, exerciseFile, finished, kit, openViewer, startViewer } from "./viewer.mjs";

const median = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
const figures = [];
function say(name, value, unit, wanted) {
  figures.push({ name, value, unit });
  console.log(`${name.padEnd(58)} ${`${value.toFixed(0)} ${unit}`.padStart(12)}   (${wanted})`);
}
const scene = ["scenes/distributed.xml", "--seed", "1"];

/// Seconds of CPU time of the process that renders; 0 if there is none.
function workerSeconds() {
  for (const name of readdirSync("/proc").filter((each) => /^\d+$/.test(each))) {
    try {
      const command = readFileSync(`/proc/${name}/cmdline`, "utf8");
      if (!command.startsWith(kit) || !command.includes("--view-worker")) continue;
      const fields = readFileSync(`/proc/${name}/stat`, "utf8").replace(/.*\) /, "").split(" ");
      return (Number(fields[11]) + Number(fields[12])) / 100;
    } catch { /* it has ended */ }
  }
  return 0;
}

async function firstPicture() {
  const start = performance.now();
  const viewer = await startViewer(...scene);
  for (let pieces = 0; pieces === 0;)
    pieces = (await (await fetch(`${viewer.address}news?after=0`)).json()).pieces.length;
  const taken = performance.now() - start;
  await viewer.end("SIGTERM");
  return taken;
}

function compileSeconds() {
  const start = performance.now();
  spawnSync("cmake", ["--build", join(kit, "build/release"), "--target", "tick1star-template"]);
  return performance.now() - start;
}

// A failure, too, ends the viewer and gives the edited file back.
const source = readFileSync(exerciseFile, "utf8");
let running = null;
process.once("exit", () => {
  running?.kill();
  writeFileSync(exerciseFile, source);
});

const browser = await launchBrowser();
const firsts = [];
for (let i = 0; i < 5; ++i) firsts.push(await firstPicture());
say("start of the program to the first picture", median(firsts), "ms", "at most 200");

const viewer = await startViewer(...scene);
running = viewer;
const { page } = await openViewer(browser, viewer);
await finished(page);
const withView = workerSeconds();
const plain = spawnSync("bash", ["-c",
  `TIMEFORMAT=%U; time build/tick1star -i scenes/distributed.xml -o ${join(kit, "build/bench.png")} --seed 1 -q`], { cwd: kit });
const without = Number(plain.stderr.toString().trim());
say("rendering, speed with the viewer", 100 * without / withView, "%", "at least 90");

await clickPixel(page, 0.5, 0.6);
// First a pixel of the ground, where each of 50 camera rays is reflected once or twice, with 10 shadow rays
// at each hit; then one between two balls.
for (const at of [{ x: 200, y: 400 }, { x: 300, y: 250 }]) {
  const clicks = await page.evaluate(async ({ x, y }) => {
    const times = [];
    for (let i = 0; i < 9; ++i) {
      const start = performance.now();
      await ask("pixel", { x: x + i, y });
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done))); // now it is painted
      times.push(performance.now() - start);
      await new Promise((done) => setTimeout(done, 300)); // the list's other lines appear later
    }
    return { times, count: rays.drawing.data.rays.length };
  }, at);
  say(`click to ${clicks.count} drawn rays`, median(clicks.times), "ms", "at most 100 for 1,000");
}

const frames = await page.evaluate(async () => {
  const { data } = rays.drawing;
  const many = Array.from({ length: 5000 }, (_, i) => data.rays[i % data.rays.length]);
  rays.drawing.data = { ...data, rays: many };
  let count = 0;
  const start = performance.now();
  while (performance.now() - start < 3000) {
    rays.drawing.orbit.turn(0.02, 0);
    rays.drawing.draw(true);
    ++count;
    await new Promise((done) => requestAnimationFrame(done));
  }
  return count / ((performance.now() - start) / 1000);
});
say("turning 5,000 rays", frames, "frames/s", "at least 30");

/// Milliseconds from a save to the first picture of the new program.
async function saveTimes(words, before) {
  const times = [];
  for (let i = 1; i <= 3; ++i) {
    await before();
    const build = await page.evaluate(() => picture.build);
    const start = performance.now();
    await writeFile(exerciseFile, `${source}// ${words} ${i}\n`);
    await page.waitForFunction((last) => picture.build > last && document.getElementById("stage").textContent, build);
    times.push(performance.now() - start);
    // Renders and tests that still run would take processor time from the next compiler.
    await page.waitForFunction(() => !document.getElementById("tests").textContent.includes("run ..."));
    await finished(page);
  }
  return median(times);
}
const saved = await saveTimes("at rest", async () => {});
const savedWhileRendering = await saveTimes("rendering", async () => {
  await page.evaluate(() => change({ seed: String(Number(settings.seed) + 1) }));
  await page.waitForFunction(() => document.getElementById("stage").textContent.endsWith("s left"));
});
await viewer.end("SIGTERM");
running = null;
const compiles = [];
for (let i = 1; i <= 3; ++i) {
  await writeFile(exerciseFile, `${source}// by hand ${i}\n`);
  compiles.push(compileSeconds());
}
say("the compiler alone", median(compiles), "ms", "");
say("save to new picture, beyond the compiler", saved - median(compiles), "ms", "at most 500");
say("the same while the last picture renders", savedWhileRendering - median(compiles), "ms", "at most 500");
await browser.close();
const [option, file] = process.argv.slice(2);
if (option === "--json") await writeFile(file, `${JSON.stringify(figures, null, 1)}\n`);
