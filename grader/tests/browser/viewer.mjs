// What tests of tick1star --view share. TICKER_VIEW_KIT is a built package of a student (view-kit.sh).
import { existsSync, readdirSync, readFileSync, readlinkSync } from "node:fs";
import { spawn, spawnSync } from "node:child_process";
import { createInterface } from "node:readline";
import { join } from "node:path";
import { openPage } from "./harness.mjs";

export const kit = process.env.TICKER_VIEW_KIT;
export const exerciseFile = join(kit, "exercise/Renderer.cpp");

const program = join(kit, "build/tick1star");

/// Starts the viewer and waits for its address. Builds the program first if it is missing, as after a build
/// that was interrupted.
export async function startViewer(...options) {
  if (!existsSync(program)) spawnSync("cmake", ["--build", join(kit, "build/release")]);
  const viewer = spawn(program, ["--view", ...options, "--quiet"],
    { cwd: kit, stdio: ["ignore", "pipe", "inherit"] });
  const lines = createInterface({ input: viewer.stdout });
  const address = await new Promise((done) => lines.once("line", done));
  return { address, kill: () => viewer.kill(), end: (signal) => new Promise((done) => { viewer.once("exit", done); viewer.kill(signal); }) };
}

export const openViewer = (browser, viewer, options = {}) =>
  openPage(browser, viewer.address, { allowed: (address) => /^(data:|about:)/.test(address) || address.startsWith(viewer.address), ...options });

/// Commands of the processes that run a program of the kit or work in its build folder.
export function processesOfTheKit() {
  return readdirSync("/proc").filter((name) => /^\d+$/.test(name)).flatMap((name) => {
    try {
      const command = readFileSync(`/proc/${name}/cmdline`, "utf8").replaceAll("\0", " ");
      return command.includes(kit) || readlinkSync(`/proc/${name}/exe`).startsWith(kit) ? [command] : [];
    } catch { return []; } // it has ended meanwhile, or belongs to another user
  });
}

/// Clicks a pixel and waits for its rays. x, y: its place, as shares of the picture's width and height.
export async function clickPixel(page, x, y) {
  await page.locator("#picture").scrollIntoViewIfNeeded();
  const box = await page.locator("#picture").boundingBox();
  const before = await page.evaluate(() => rays.drawing.data);
  await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  await page.waitForFunction((last) => rays.drawing.data.about && rays.drawing.data.about !== last, before.about);
}

/// Waits until the picture is rendered to the end.
export const finished = (page) =>
  page.waitForFunction(() => document.getElementById("stage").textContent === "done");
