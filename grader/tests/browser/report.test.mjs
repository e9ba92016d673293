// report.html in a browser. TICKER_CLASS is a graded class, TICKER_EXAMPLES a class of made-up results with
// everything that a page can show.
import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { pathToFileURL } from "node:url";
import { join } from "node:path";
import { accessibilityFaults, launchBrowser, openPage, overflow } from "./harness.mjs";

const graded = (name, page = "report.html") => pathToFileURL(join(process.env.TICKER_CLASS, name, page)).href;
const example = (name) => pathToFileURL(join(process.env.TICKER_EXAMPLES, name, "report.html")).href;

let browser;
before(async () => { browser = await launchBrowser(); });
after(() => browser.close());

/// Opens a report, passes it to `look`, and expects no problem (see openPage).
async function withReport(url, look, options) {
  const { page, problems } = await openPage(browser, url, options);
  await look(page);
  assert.deepEqual(problems, []);
  await page.close();
}

for (const [what, url] of Object.entries({
  "of a mistake in T1": graded("bump-inverted-u"),
  "of a mistake in T2": graded("distributed-off-centre"),
  "of code that does not compile": graded("does-not-compile"),
  "of a submission that passed, with all there is": example("Ada Lovelace"),
}))
  test(`a report ${what} is quiet, whole, accessible, and fits a telephone`, () =>
    withReport(url, async (page) => {
      const broken = await page.locator("img").evaluateAll((images) =>
        images.filter((image) => !image.complete || image.naturalWidth === 0).length);
      assert.equal(broken, 0, "pictures that do not load");
      assert.deepEqual(await accessibilityFaults(page), []);
      await page.setViewportSize({ width: 360, height: 740 });
      assert.equal(await overflow(page), 0, "scrolls sideways");
    }));

test("a report runs nothing that a student wrote", () =>
  withReport(example("=hostile<img src=x onerror=alert(3)>\"'&"), async (page) => {
    assert.equal(await page.locator("script:not([type='application/json'])").count(), 1);
    const ran = await page.evaluate(() => {
      const script = document.createElement("script");
      script.textContent = "window.intruder = true";
      document.body.append(script);
      return window.intruder === true;
    });
    assert.equal(ran, false, "the page's policy let a foreign script run");
  }, { expectRefusals: true }));

test("a report draws the rays of one pixel, with a line for each", () =>
  withReport(graded("distributed-off-centre"), async (page) => {
    const ofLens = page.locator(".ray-faces", { hasText: "The lens, and where rays start on it" });
    const drawing = page.locator(".ray-figure", { has: ofLens });
    const lines = drawing.getByRole("listbox", { name: "Rays" }).locator("li");
    await lines.nth(10).waitFor();
    await lines.nth(2).click();
    assert.equal(await drawing.locator("[aria-selected=true]").count(), 1);
    assert.ok((await page.content()).length < 3_000_000);
  }));

test("names in a drawing are not cut off at its edge", () =>
  withReport(graded("distributed-off-centre"), async (page) => {
    await page.evaluate(() => {
      window.cut = [];
      window.names = 0;
      const { fillText } = CanvasRenderingContext2D.prototype;
      CanvasRenderingContext2D.prototype.fillText = function (words, x, y) {
        const { width } = this.canvas.getBoundingClientRect();
        window.names += 1;
        if (x < width && x + this.measureText(words).width > width) window.cut.push(words);
        return fillText.call(this, words, x, y);
      };
    });
    for (const width of [390, 800]) {
      const before = await page.evaluate(() => window.names);
      await page.setViewportSize({ width, height: 800 });
      await page.waitForFunction((drawn) => window.names > drawn, before);
    }
    for (const button of await page.getByRole("button", { name: "Nearer" }).all()) {
      const before = await page.evaluate(() => window.names);
      await button.click();
      await page.waitForFunction((drawn) => window.names > drawn, before);
    }
    assert.ok(await page.evaluate(() => window.names) > 10);
    assert.deepEqual(await page.evaluate(() => window.cut), []);
  }));

test("a report draws the normals of a failed T1 beside what was expected; the student's has none of these", async () => {
  await withReport(graded("bump-inverted-u"), async (page) => {
    const drawing = page.locator(".ray-figure").first();
    assert.match(await drawing.locator(".ray-legend").textContent(), /smooth normals: 23.*expected normals: 23.*normals given: 23/s);
    assert.match(await drawing.locator("canvas").first().getAttribute("aria-label"), /23 points in 3-D/);
  });
  await withReport(graded("bump-inverted-u", "student.html"), async (page) => {
    const legend = await page.locator(".ray-figure .ray-legend").first().textContent();
    assert.match(legend, /normals given: 23/);
    assert.doesNotMatch(legend, /expected/);
    const [canvas, card] = await Promise.all([page.locator(".ray-figure canvas").first().boundingBox(),
      page.locator(".ray-figure").first().boundingBox()]);
    assert.ok(canvas.width > card.width / 2, `a lone drawing has ${canvas.width} of ${card.width} pixels`);
  });
});

test("a report of the class leads back to it, one by itself has no such link", () =>
  withReport(graded("does-not-compile"), async (page) => {
    const back = page.getByRole("link", { name: "All submissions" });
    assert.equal(await back.count(), 0);
    await page.goto(`${page.url()}#class`);
    await back.click();
    await page.waitForURL(/index\.html$/);
    assert.match(await page.getByRole("heading", { level: 1 }).textContent(), /submissions/);
  }));

describe("a comparison", () => {
  let page;
  let problems;
  let viewer;
  let frame;
  before(async () => {
    ({ page, problems } = await openPage(browser, graded("bump-inverted-u")));
    viewer = page.locator(".viewer").first();
    frame = viewer.locator(".expected .frame");
  });
  after(async () => {
    await page.close();
    assert.deepEqual(problems, []);
  });

  const button = (act) => viewer.locator(`[data-act=${act}]`);
  const pressed = (act) => button(act).getAttribute("aria-pressed");
  const showing = (one = viewer) => one.locator(".showing").textContent();
  const clip = () => viewer.locator(".submitted .frame").evaluate((each) => getComputedStyle(each).clipPath);

  /// For each picture: its corner within its frame (right, down) and its width, in widths of the frame.
  const places = () => viewer.locator(".frame img").evaluateAll((images) => images.map((image) => {
    const box = image.parentElement.getBoundingClientRect();
    const inside = image.getBoundingClientRect();
    return [(inside.x - box.x) / box.width, (inside.y - box.y) / box.width, inside.width / box.width]
      .map((part) => part.toFixed(2)).join(" ");
  }));

  /// Sets the viewer to side by side without zoom. Returns a function from shares of the picture's width and
  /// height to a place of the pointer in pixels.
  async function fresh() {
    await button("side").click();
    while ((await viewer.locator("output").textContent()) !== "1×") await button("out").click();
    await frame.scrollIntoViewIfNeeded();
    const { x, y, width, height } = await frame.boundingBox();
    return (right, down) => [x + right * width, y + down * height];
  }

  test("lays one picture over the other, as far as the slider says", async () => {
    await fresh();
    const slider = viewer.getByRole("slider");
    await slider.fill("25");
    assert.match(await clip(), /75%/);
    assert.equal(await pressed("over"), "true");
    assert.equal(await pressed("side"), "false");
    await slider.press("ArrowRight");
    assert.equal(await slider.inputValue(), "26");
    await button("side").click();
    assert.equal(await clip(), "none");
  });

  test("moves the slider with the pointer in the picture", async () => {
    await fresh();
    await button("over").click();
    const { x, y, width } = await frame.boundingBox();
    await page.mouse.move(x + 0.5 * width, y + 50);
    await page.mouse.down();
    await page.mouse.move(x + 0.2 * width, y + 60);
    await page.mouse.up();
    await page.mouse.move(x + 0.6 * width, y + 60);
    assert.equal(await viewer.getByRole("slider").inputValue(), "80");
  });

  test("blinks between expected and submitted by a key", async () => {
    await fresh();
    await page.keyboard.press("b");
    assert.equal(await showing(), "Showing: submitted");
    await page.keyboard.press("b");
    assert.equal(await showing(), "Showing: expected");
    assert.equal(await pressed("blink"), "true");
    await page.keyboard.press("s");
    assert.equal(await showing(), "");
    assert.equal(await pressed("side"), "true");
  });

  test("takes the keys where the focus is", async () => {
    await fresh();
    const last = page.locator(".viewer").last();
    await last.locator(".stage").focus();
    await page.keyboard.press("b");
    assert.equal(await showing(last), "Showing: submitted");
    assert.equal(await showing(), "");
  });

  test("zooms and moves all its pictures together", async () => {
    await fresh();
    await viewer.locator(".stage").focus();
    const seen = [await places()];
    for (const key of ["+", "+", "ArrowRight", "ArrowDown"]) {
      await page.keyboard.press(key);
      seen.push(await places());
    }
    assert.equal(seen[0].length, 3, "expected, submitted and the FLIP map");
    for (const each of seen) assert.equal(new Set(each).size, 1, `not together: ${each}`);
    assert.equal(new Set(seen.map(String)).size, seen.length, `a key that does nothing: ${seen}`);
    assert.equal(await viewer.locator("output").textContent(), "4×");
  });

  test("keeps the point of a double click in its place, and is dragged", async () => {
    const at = await fresh();
    await page.mouse.dblclick(...at(0.25, 0.52));
    assert.deepEqual(new Set(await places()), new Set(["-0.25 -0.39 2.00"]));
    await page.mouse.move(...at(0.5, 0.52));
    await page.mouse.down();
    await page.mouse.move(...at(0.6, 0.52));
    await page.mouse.up();
    assert.deepEqual(new Set(await places()), new Set(["-0.15 -0.39 2.00"]));
  });

  test("tells the colours under the pointer", async () => {
    const at = await fresh();
    await page.mouse.move(...at(0.01, 0.01));
    assert.match(await viewer.locator(".readout").textContent(),
      /^\(3, 2\)expected \d+ \d+ \d+submitted \d+ \d+ \d+$/);
  });

  test("is on paper without its buttons, with all that was folded", async () => {
    await page.emulateMedia({ media: "print" });
    await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
    assert.equal(await page.locator("details:not([open])").count(), 0);
    assert.equal(await page.locator("button:visible, input:visible").count(), 0);
    assert.ok(await viewer.locator("img").first().isVisible());
  });
});
