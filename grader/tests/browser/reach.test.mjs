// The ticking session in narrow columns, on a phone and by the keyboard alone.
// TICKER is the program, TICKER_CLASS a graded class.
import assert from "node:assert/strict";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { launchBrowser, openPage, overflow } from "./harness.mjs";
import { killSessions, makeClass, openSession, saved, showing, shown, startSession } from "./session.mjs";

let browser;
let out;
let session;
before(async () => {
  browser = await launchBrowser();
  out = makeClass(5);
  session = await startSession(out);
});
after(async () => {
  await browser.close();
  killSessions();
});

const inverted = "Jürgen, jr_1000";
const offCentre = "O'Neill #1? 100%_1001";

/// Opens a submission of the session in a window of this size.
async function openAt(name, width, height) {
  const { page } = await openSession(browser, session, { width, height });
  await shown(page);
  await page.evaluate((one) => { location.hash = `at=${encodeURIComponent(one)}`; }, name);
  await showing(page, name);
  return page;
}

test("a drawing has the width of its column where that is narrow, and its words stand below", async () => {
  const page = await openAt(inverted, 1280, 800);
  const widthOf = async (what) => (await page.locator(`.ray-figure ${what}`).first().boundingBox()).width;
  const whole = (await page.locator(".ray-figure").first().boundingBox()).width;
  assert.ok(whole < 500, "the code stands beside it");
  assert.ok(await widthOf(".ray-stage") > 0.95 * whole);
  assert.ok(await widthOf(".ray-story") > 0.95 * whole);
  await page.setViewportSize({ width: 1200, height: 800 }); // the code stands below, and the words beside the drawing
  assert.ok(await widthOf(".ray-stage") > 1.4 * await widthOf(".ray-story"));
  await page.close();
});

test("the element with the focus stays visible between the bars", async () => {
  for (const [width, height] of [[1280, 800], [390, 844]]) {
    const page = await openAt(offCentre, width, height);
    const hidden = [];
    let measured = 0;
    for (const key of ["Tab", "Shift+Tab"])
      for (let i = 0; i < 45; ++i) {
        await page.keyboard.press(key);
        const found = await page.evaluate(async () => {
          await new Promise((done) => requestAnimationFrame(done));
          const one = document.activeElement;
          if (!one.closest("main") || one.matches("main")) return null;
          const [box, top, bottom] = [one, document.querySelector(".top"), document.querySelector(".decide")]
            .map((each) => each.getBoundingClientRect());
          const seen = Math.min(box.bottom, bottom.top) - Math.max(box.top, top.bottom);
          return seen < Math.min(box.height, 20) ? one.outerHTML.slice(0, 80) : "";
        });
        if (found !== null) ++measured;
        hidden.push(found);
      }
    assert.ok(measured > 10, `${measured} elements had the focus`);
    assert.deepEqual(hidden.filter(Boolean), [], `${width} x ${height}`);
    await page.close();
  }
});

test("on a phone the keys begin at their heading, and the footer cuts no words off", async () => {
  const page = await openAt(inverted, 390, 700);
  await page.locator("[data-act=help]").click();
  assert.ok((await page.getByRole("heading", { name: "Keys" }).boundingBox()).y > 0);
  await page.keyboard.press("Escape");
  await page.evaluate(() => { location.hash = "view=sheet"; });
  await page.locator(".standing", { hasText: "not looked at yet: scroll on" }).waitFor();
  assert.ok(await page.locator(".standing").evaluate((one) =>
    one.scrollWidth <= one.clientWidth && one.scrollHeight <= one.clientHeight), "all of it is seen");
  await page.close();
});

test("the list says by which finding it was made shorter where its filters are folded", async () => {
  const page = await openAt(inverted, 1280, 800);
  await page.evaluate(() => { location.hash = "view=summary"; });
  await page.getByRole("button", { name: "dof.off-centre", exact: true }).click();
  assert.ok(await page.locator("#finding").isHidden());
  assert.equal(await page.locator(".shown").textContent(), "1 of 5 shown: dof.off-centre");
  await page.close();
});

test("a long word of a comment on a line does not widen the student's page", async () => {
  const page = await openAt(inverted, 1280, 800);
  await page.getByLabel("You are").fill("ann");
  await page.locator("main").focus();
  await page.keyboard.press("l");
  await page.keyboard.press("Enter");
  await page.locator("#comment textarea").fill(`- ${"averylongword".repeat(20)}`);
  await page.keyboard.press("Control+Enter");
  await saved(page);
  await page.close();
  await session.kill("SIGTERM");
  const { page: student } = await openPage(browser, pathToFileURL(join(out, inverted, "student.html")).href, { width: 390 });
  await student.getByText("Your ticker about your code").waitFor();
  assert.equal(await overflow(student), 0, "scrolls sideways");
  await student.close();
});
