// The viewer, tick1star --view, in a browser.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { readFile, writeFile } from "node:fs/promises";
import { accessibilityFaults, launchBrowser, overflow } from "./harness.mjs";
import { clickPixel, exerciseFile, finished, openViewer, processesOfTheKit, startViewer } from "./viewer.mjs";

let browser;
let source;
let viewer;
before(async () => {
  browser = await launchBrowser();
  source = await readFile(exerciseFile, "utf8");
});
after(() => browser.close());
afterEach(async () => {
  await viewer?.end("SIGTERM");
  viewer = null;
  // A file that is written anew is compiled anew.
  if (await readFile(exerciseFile, "utf8") !== source) await writeFile(exerciseFile, source);
  assert.deepEqual(processesOfTheKit(), [], "left behind");
});

/// Starts the viewer with a small picture, passes its page to `look`, and expects no problem (see openPage).
async function withPage(look, options) {
  viewer = await startViewer("scenes/distributed.xml", "-r", "160x120", "--dof-rays", "8", "--seed", "1");
  const { page, problems } = await openViewer(browser, viewer, options);
  await look(page, problems);
  assert.deepEqual(problems, []);
  await page.close();
}

const isBeforeOffered = (page) => page.evaluate(() => !document.querySelector("#compare [value=before]").disabled);
const text = (page, id) => page.locator(`#${id}`).textContent();
const showing = (page, id, words) => page.waitForFunction(([where, what]) =>
  document.getElementById(where).textContent.includes(what), [id, words]);

/// Waits until nothing goes on any more: the viewer builds when it starts, and then may render once more.
async function quiet(page) {
  await showing(page, "tests", "T2.2");
  await finished(page);
}

/// The addresses of the page's requests for `path` from now on.
function asksTo(page, path) {
  const asked = [];
  page.on("request", (one) => { if (new URL(one.url()).pathname.endsWith(`/${path}`)) asked.push(one.url()); });
  return asked;
}

/// Holds the next request for `path` back until `answer` is called; the viewer answers it then, unless an answer is
/// given here. `isAsked`: until the request is there.
async function heldBack(page, path, answer) {
  const held = {};
  held.isAsked = new Promise((asked) => { held.tell = asked; });
  const isLetGo = new Promise((letGo) => { held.answer = letGo; });
  await page.route(new RegExp(`/${path}($|\\?)`), async (route) => {
    held.tell();
    await isLetGo;
    await (answer ? route.fulfill(answer) : route.continue());
  }, { times: 1 });
  return held;
}

test("the viewer's page is quiet, accessible, fits a telephone, and ends with all that it started", () =>
  withPage(async (page) => {
    await finished(page);
    await showing(page, "tests", "T2.2");
    await clickPixel(page, 0.5, 0.6);
    assert.deepEqual(await accessibilityFaults(page), []);
    await page.setViewportSize({ width: 360, height: 740 });
    assert.equal(await overflow(page), 0, "scrolls sideways");
  }));

test("a click draws the pixel's rays; a line and its ray are highlighted together", () =>
  withPage(async (page) => {
    await finished(page);
    await clickPixel(page, 0.5, 0.6);
    const list = page.getByRole("listbox", { name: "Rays" });
    assert.equal(await list.locator(".ray-camera").count(), 8);
    assert.match(await page.locator(".ray-story").textContent(), /8 camera rays; they start at x from/);
    await list.locator("li").nth(3).click();
    assert.equal(await page.evaluate(() => rays.drawing.chosen), 3);
    await list.press("ArrowDown");
    assert.equal(await page.evaluate(() => rays.drawing.chosen), 4);
    assert.equal(await list.locator("[aria-selected=true]").getAttribute("data-ray"), "4");
    // and the other way round: a click on that ray in the drawing
    const at = await page.evaluate(() => {
      rays.choose(-1);
      const [ax, ay, bx, by] = rays.drawing.orbit.segment(rays.drawing.data.rays[0].a, rays.drawing.data.rays[0].b);
      return { x: (ax + bx) / 2, y: (ay + by) / 2 };
    });
    await page.locator(".ray-stage canvas").click({ position: at });
    assert.equal(await list.locator("[aria-selected=true]").count(), 1);
    assert.match(await list.locator("[aria-selected=true]").textContent(), /camera ray/);
  }));

test("the drawing turns by mouse and by keys, and a surface can be asked", () =>
  withPage(async (page) => {
    await finished(page);
    await clickPixel(page, 0.5, 0.6);
    const yaw = () => page.evaluate(() => rays.drawing.orbit.yaw);
    const canvas = page.locator(".ray-stage canvas");
    const first = await yaw();
    await canvas.press("ArrowLeft");
    assert.notEqual(await yaw(), first);
    await canvas.press("0");
    assert.equal(await yaw(), first);
    const box = await canvas.boundingBox();
    await page.mouse.move(box.x + 50, box.y + 50);
    await page.mouse.down();
    await page.mouse.move(box.x + 120, box.y + 60, { steps: 4 });
    await page.mouse.up();
    assert.notEqual(await yaw(), first);
    await page.locator(".ray-list li").first().click();
    await page.getByRole("button", { name: "Light at the end of this ray" }).click();
    await page.waitForFunction(() => rays.drawing.data.about.startsWith("The point"));
    assert.match(await page.locator(".ray-faces").textContent(), /light 1 as the point sees it: \d+ of 10 rays arrive/);
  }));

test("only the main button of the mouse asks about a surface", () =>
  withPage(async (page) => {
    await quiet(page);
    await clickPixel(page, 0.5, 0.6);
    const canvas = page.locator(".ray-stage canvas");
    const asked = asksTo(page, "point");
    const position = await page.evaluate(() => {
      rays.drawing.hidden = new Set(Object.keys(kRayKinds)); // no ray is in the way
      const { orbit } = rays.drawing;
      const [x, y] = [0.5, 0.25].map((share, i) => share * (i ? orbit.height : orbit.width));
      for (let below = y; below < orbit.height; below += 5) if (surfaceAt(rays.drawing, x, below)) return { x, y: below };
      return null;
    });
    for (const button of ["right", "middle"]) await canvas.click({ position, button });
    await canvas.click({ position });
    await page.waitForFunction(() => rays.drawing.data.about.startsWith("The point"));
    assert.equal(asked.length, 1);
  }));

test("a click while a question waits is asked even if that question fails", () =>
  withPage(async (page, problems) => {
    await quiet(page);
    const first = await heldBack(page, "pixel", { status: 409, body: "Your code crashed at this question." });
    for (const x of [10, 20]) await page.evaluate((at) => { ask("pixel", { x: at, y: 20 }); }, x);
    first.answer();
    await page.waitForFunction(() => rays.drawing.data.about?.includes("(20, 20)"));
    assert.match(problems.splice(0).join(), /^console: .*409/, "Chromium notes the failure, and nothing else");
  }));

test("another scene takes the rays and the mark of the last one away, also those that come late", () =>
  withPage(async (page) => {
    await quiet(page);
    await clickPixel(page, 0.5, 0.6);
    const asked = asksTo(page, "pixel");
    const late = await heldBack(page, "pixel");
    await page.evaluate(() => { ask("pixel", { x: 12, y: 12 }); });
    await late.isAsked;
    await page.getByLabel("Scene").selectOption("bump-mapping.xml");
    await page.waitForFunction(() => settings.scene === "bump-mapping.xml");
    const isGone = async () => {
      assert.equal(await page.locator("#rays").isVisible(), false, "rays");
      assert.equal(await page.locator("#mark").isVisible(), false, "mark");
    };
    await isGone();
    late.answer();
    await page.waitForFunction(() => !isAsking);
    await isGone();
    await page.getByRole("slider", { name: "Bounces, as a slider" }).fill("3");
    await page.waitForFunction(() => settings.bounces === "3");
    await finished(page);
    assert.equal(asked.length, 1, "the new scene is not asked about the old pixel");
    await isGone();
  }));

test("all of it can be reached by keys", () =>
  withPage(async (page) => {
    await finished(page);
    await page.locator("#picture").focus();
    await page.keyboard.press("ArrowRight");
    assert.match(await text(page, "status"), /Pixel \(\d+, \d+\)/);
    await page.keyboard.press("Enter");
    await page.locator("#rays").waitFor();
    for (const wanted of ["CANVAS", "BUTTON", "INPUT", "OL"])
      await page.waitForFunction((name) =>
        [...document.querySelectorAll("#rays *")].some((one) => one.tagName === name && one.tabIndex === 0), wanted);
  }));

test("a slider renders again, and a value out of range is refused with words", () =>
  withPage(async (page, problems) => {
    await finished(page);
    const number = page.getByRole("spinbutton", { name: "Aperture" });
    assert.equal(await number.inputValue(), "0.2");
    await page.getByRole("slider", { name: "Aperture, as a slider" }).fill("0");
    await page.waitForFunction(() => settings.aperture === "0");
    await finished(page);
    assert.equal(await number.inputValue(), "0");
    await page.getByRole("spinbutton", { name: "Camera rays" }).fill("0");
    await showing(page, "status", "expected a whole number from 1");
    assert.match(problems.splice(0).join(), /^console: .*400/, "Chromium notes the refusal, and nothing else");
  }));

test("a field that is emptied on the way to another number changes nothing, and shows what is in force when left", () =>
  withPage(async (page) => {
    await finished(page);
    const number = page.getByRole("spinbutton", { name: "Shadow rays" });
    let sent = 0;
    page.on("request", (one) => { sent += one.method() === "POST" ? 1 : 0; });
    await number.fill("");
    await number.blur();
    assert.equal(await number.inputValue(), "10");
    await number.fill("5");
    await page.waitForFunction(() => settings.shadowRays === "5");
    assert.equal(sent, 1, "only the new number is sent");
  }));

test("the settings of the start come back, in every page", () =>
  withPage(async (page) => {
    await finished(page);
    await page.getByRole("slider", { name: "Aperture, as a slider" }).fill("0");
    await page.waitForFunction(() => settings.aperture === "0");
    const { page: second } = await openViewer(browser, viewer);
    await finished(second);
    await second.getByRole("button", { name: "As it was started" }).click();
    await page.waitForFunction(() => settings.aperture === "0.2");
    await second.close();
  }));

test("what was before the edit is not laid over another scene", () =>
  withPage(async (page) => {
    await finished(page);
    await page.evaluate(() => { picture.kept.before = picture.copy(picture.canvas); showCompare(); });
    await page.getByLabel("Compare with").selectOption("before");
    assert.equal(await page.locator("#other").isVisible(), true);
    await page.getByLabel("Scene").selectOption("bump-mapping.xml");
    await page.waitForFunction(() => settings.scene === "bump-mapping.xml");
    assert.equal(await isBeforeOffered(page), false);
    assert.equal(await page.getByLabel("Compare with").inputValue(), "");
    assert.equal(await page.locator("#other").isVisible(), false);
  }));

test("any number of rays fits into a view and into the picture of the lens", () =>
  withPage(async (page) => {
    const target = await page.evaluate(() => {
      const orbit = new Orbit();
      orbit.frame(Array.from({ length: 500000 }, (_, i) => [i % 3, 1, i % 5]));
      const points = Array.from({ length: 200000 }, () => ({ x: 1, y: 1, k: "camera" }));
      drawFace(document.createElement("canvas"), { radius: 1, isSquare: true, points });
      return orbit.target;
    });
    assert.deepEqual(target, [1, 1, 2]);
  }));

test("the first view shows all that belongs to the first hits, and fills the canvas with it", () =>
  withPage(async (page) => {
    await finished(page);
    await clickPixel(page, 0.5, 0.6);
    const { width, height, places } = await page.evaluate(() => {
      const { orbit, data } = rays.drawing;
      return { width: orbit.width, height: orbit.height, places: pointsOf(data).map((point) => orbit.project(point)) };
    });
    const sides = [0, 1].map((i) => places.map((place) => place[i]));
    const [low, high] = [Math.min, Math.max].map((most) => sides.map((side) => most(...side)));
    assert.ok(low[0] >= 0 && high[0] <= width && low[1] >= 0 && high[1] <= height, `${low} to ${high}`);
    assert.ok(Math.max((high[0] - low[0]) / width, (high[1] - low[1]) / height) > 0.75, `${low} to ${high}`);
  }));

test("rays that take the place of others keep the zoom", () =>
  withPage(async (page) => {
    await finished(page);
    await clickPixel(page, 0.5, 0.6);
    const [whole, near] = await page.evaluate(() => {
      const { drawing } = rays;
      const distance = (keepsView) => { drawing.frame(keepsView); return drawing.orbit.distance; };
      const whole = distance(false);
      drawing.orbit.zoomBy(2);
      return [whole, distance(true)];
    });
    assert.ok(Math.abs(near - whole / 2) < 1e-6 * whole, `${near} of ${whole}`);
  }));

test("a sphere's outline is where lines from the eye touch it", () =>
  withPage(async (page) => {
    const { touches, inside } = await page.evaluate(() => {
      const [eye, centre] = [[0, 1, -2], [0.5, 0, 1]];
      const { centre: middle, radius, axis } = outlineOf(eye, centre, 1.5);
      const touches = besides(axis).map((aside) => plus(middle, aside, radius)).map((point) =>
        [Math.hypot(...minus(point, centre)), dot(minus(point, centre), minus(point, eye))]);
      return { touches, inside: outlineOf(eye, centre, 4) };
    });
    for (const [distance, slant] of touches) {
      assert.ok(Math.abs(distance - 1.5) < 1e-9, `${distance} from the centre`);
      assert.ok(Math.abs(slant) < 1e-9, `not at right angles: ${slant}`);
    }
    assert.equal(inside, null);
  }));

test("another picture can be laid over this one", () =>
  withPage(async (page) => {
    await finished(page);
    await page.getByLabel("Compare with").selectOption("pinhole");
    await page.waitForFunction(() => picture.kept.pinhole);
    assert.equal(await page.locator("#other").isVisible(), true);
  }));

test("a slider asks for one picture to compare with at a time, and shows that of the newest settings", () =>
  withPage(async (page) => {
    await quiet(page);
    const asked = asksTo(page, "pinhole");
    const first = await heldBack(page, "pinhole");
    await page.getByLabel("Compare with").selectOption("pinhole");
    await first.isAsked;
    const slider = page.getByRole("slider", { name: "Bounces, as a slider" });
    for (const bounces of ["3", "4", "1"]) {
      await slider.fill(bounces);
      await page.waitForFunction((wanted) => settings.bounces === wanted, bounces);
    }
    const second = await heldBack(page, "pinhole");
    first.answer();
    await second.isAsked;
    assert.equal(await page.evaluate(() => picture.kept.pinhole), null, "the old settings' picture is not taken");
    second.answer();
    await page.waitForFunction(() => picture.kept.pinhole);
    assert.equal(await page.locator("#other").isVisible(), true);
    assert.equal(asked.length, 2);
  }));

test("an error of the compiler shows with its line, a right edit with its picture, a mistake with its test", () =>
  withPage(async (page) => {
    await finished(page);
    await showing(page, "tests", "T2.1");
    const build = await page.evaluate(() => picture.build);
    const builtAgain = (times) => page.waitForFunction((wanted) => picture.build === wanted, build + times);
    await writeFile(exerciseFile, source.replace("return colour;", "return colour"));
    await showing(page, "build", "Renderer.cpp, line ");
    assert.match(await text(page, "build"), /expected .;.* before/);
    assert.equal(await page.evaluate(() => picture.build), build, "the last picture stays");
    await clickPixel(page, 0.3, 0.3); // and answers
    await writeFile(exerciseFile, source.replace("return colour;", "return colour * 0.5;"));
    await builtAgain(1);
    await finished(page);
    await showing(page, "tests", "Not yet: T2.1");
    assert.equal(await isBeforeOffered(page), true);
    await writeFile(exerciseFile, source);
    await builtAgain(2);
    await showing(page, "tests", "passed");
  }));

test("a render that a save gave up goes on where the new code does not compile", async () => {
  viewer = await startViewer("scenes/distributed.xml", "-r", "320x240", "--seed", "1");
  const { page } = await openViewer(browser, viewer);
  await page.waitForFunction(() => document.getElementById("stage").textContent.endsWith("s left"));
  const build = await page.evaluate(() => picture.build);
  await writeFile(exerciseFile, source.replace("return colour;", "return colour"));
  await showing(page, "build", "Renderer.cpp, line ");
  await finished(page);
  assert.equal(await page.evaluate(() => picture.build), build);
  await page.close();
});

test("code that crashes says so and takes nothing with it", () =>
  withPage(async (page) => {
    await finished(page);
    await writeFile(exerciseFile, source.replace("return colour;", "__builtin_trap(); return colour;"));
    await showing(page, "trouble", "Your code crashed");
    await writeFile(exerciseFile, source);
    await page.waitForFunction(() => document.getElementById("trouble").hidden);
    await finished(page);
  }));

test("a page that lost its viewer for a while, as in a laptop's sleep, takes back that it has ended", () =>
  withPage(async (page, problems) => {
    await finished(page);
    const { context } = browser;
    await context.setOffline(true);
    await showing(page, "status", "has ended");
    await context.setOffline(false);
    await page.waitForFunction(() => document.getElementById("status").textContent === "");
    await finished(page);
    problems.splice(0);
  }));

test("a viewer that is killed leaves no process behind, and its page says that it has ended", async () => {
  viewer = await startViewer("scenes/distributed.xml", "--seed", "1");
  const { page } = await openViewer(browser, viewer);
  await page.waitForFunction(() => document.getElementById("stage").textContent !== "");
  await writeFile(exerciseFile, `${source}\n// saved\n`);
  await showing(page, "build", "Building");
  await viewer.end("SIGKILL");
  viewer = null;
  await showing(page, "status", "has ended");
  await Promise.all([page.waitForEvent("requestfailed"), page.locator("#picture").click()]);
  assert.match(await text(page, "status"), /has ended/, "whatever is tried then");
  for (let tries = 0; tries < 100 && processesOfTheKit().length > 0; ++tries) await page.waitForTimeout(50);
  await page.close();
});
