// A ticker's evening: grades a class of 14 in Moodle's layout, then uses every button and key of the session.
// After each use the tests compare what another process reads from the disk, and what the page says. They run
// one after the other on one page. TICKER is the program, TICKER_SAMPLES the sample class.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { after, before, test } from "node:test";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { accessibilityFaults, launchBrowser, overflow } from "./harness.mjs";
import { killSessions, onDisk, openSession, rowsOf, saved, shown, showing, startSession, ticker } from "./session.mjs";

const handedIn = {
  "Ann Lee_1001": "awarded/reference-bump",
  "Bo Chen_1002": "notAwarded/bump-inverted-u",
  "Cleo Díaz_1003": "notAwarded/bump-inverted",
  "Dai O'Neill_1004": "notAwarded/bump-swapped-axes",
  "Eve Åberg_1005": "awarded/bump-bilinear",
  "Fay Wu_1006": "needsReview/no-screenshot",
  "Gil Mor_1007": "notAwarded/does-not-compile",
  "Hal Ito_1008": "notAwarded/template-untouched",
  "Ina Roy_1009": "needsReview/two-versions",
  "Jon Poe_1010": "awarded/reference-distributed",
  "Kay Fox_1011": "notAwarded/distributed-off-centre",
  "Leo Sun_1012": "notAwarded/distributed-hard-shadows",
  "Mia Zhu_1013": "notAwarded/bump-inverted-u",
  "Noa Bly_1014": "needsReview/picture-of-the-test-map",
};
const names = Object.keys(handedIn);
const [ann, bo, cleo, dai, eve, fay, gil, , , jon, kay, , mia, noa] = names;
const zone = "Asia/Kathmandu"; // 5:45 ahead of UTC: no other zone's time is mistaken for it

const folder = mkdtempSync(join(tmpdir(), "ticker-walk-"));
const out = join(folder, "out");
let browser;
let session;
let page;
let problems;
before(async () => {
  for (const [name, sample] of Object.entries(handedIn)) {
    const handIn = join(folder, "CS-Tick1-4711", `${name}_assignsubmission_file_`);
    mkdirSync(handIn, { recursive: true });
    cpSync(join(process.env.TICKER_SAMPLES, sample), handIn, {
      recursive: true, filter: (path) => !/(README\.txt|expected\.json)$/.test(path), // are not the student's
    });
  }
  execFileSync(ticker, ["grade", join(folder, "CS-Tick1-4711"), "-o", out, "--seed", "1", "--quiet"]);
  session = await startSession(out);
  browser = await launchBrowser({ timezoneId: zone, locale: "en-GB" });
  ({ page, problems } = await openSession(browser, session));
  await showing(page, ann);
});
after(async () => {
  await browser.close();
  killSessions();
  rmSync(folder, { recursive: true, force: true });
});

// --- the buttons and keys in use -----------------------------------------------------------------

const used = new Set();

/// A button's dialog (or "page") and its action, such as "comment: quote".
const nameOf = (button) => `${button.closest("dialog")?.id || "page"}: ${button.dataset.act || button.value || "close"}`;

async function press(key) {
  used.add(`key ${key}`);
  await page.keyboard.press(key === "−" ? "-" : key);
}

async function click(selector) {
  const button = page.locator(selector).first();
  used.add(await button.evaluate(nameOf));
  await button.click();
}

const dialog = () => page.evaluate(() => document.querySelector("dialog[open]")?.id ?? "");
const heading = () => page.locator("main h1").textContent();
const standing = () => page.locator(".standing").textContent();
const listed = () => page.locator(".list li:visible .name").allTextContents();
const isDisabled = (act) => page.locator(`.buttons [data-act=${act}]`).isDisabled();

/// The decisions on disk about one submission, after the page reports that all is saved.
async function decision(name) {
  await saved(page);
  const { ruling, decidedBy, comment } = onDisk(out)[name];
  return [ruling, decidedBy, comment];
}

async function open(name) {
  await page.locator(".list button", { hasText: name }).click();
  await showing(page, name);
}

// --- the walk ----------------------------------------------------------------------------------

test("the class is there, with names as Moodle has them", async () => {
  assert.deepEqual(await listed(), names);
  assert.equal(await heading(), ann);
  for (const [name, { verdict }] of Object.entries(onDisk(out)))
    assert.equal(verdict, handedIn[name].split("/")[0], name);
});

test("a name is asked for once, and blanks are none", async () => {
  await press("a");
  assert.equal(await dialog(), "ask");
  assert.ok(await page.locator("#ask-why").isHidden(), "nothing is overruled here");
  await page.keyboard.type("  ");
  await press("Enter");
  assert.equal(await dialog(), "ask");
  await click("#ask [value=cancel]");
  assert.deepEqual(await decision(ann), ["", "", ""]);
  assert.equal(await heading(), ann);
  await click("[data-act=award]");
  await page.keyboard.type("Dee");
  await click("#ask [value=save]");
  await showing(page, bo);
  assert.deepEqual(await decision(ann), ["awarded", "Dee", ""]);
  assert.equal(await page.getByLabel("You are").inputValue(), "Dee");
  await press("n");
  await showing(page, cleo);
  assert.deepEqual(await decision(bo), ["notYet", "Dee", ""]);
});

test("who overrules is asked for a reason, in one line", async () => {
  await click("[data-act=award]");
  assert.equal(await page.locator("#ask h2").textContent(), "The proposal is “not awarded”. Why “awarded”?");
  assert.ok(await page.locator("#ask-who").isHidden());
  for (const nothing of ["", "  "]) {
    await page.keyboard.type(nothing);
    await press("Enter");
    assert.equal(await dialog(), "ask");
  }
  await press("Escape");
  assert.equal(await dialog(), "");
  assert.deepEqual(await decision(cleo), ["", "", ""]);
  await press("a");
  await page.keyboard.type("shown at the desk, with another map");
  await press("Enter");
  await showing(page, dai);
  assert.deepEqual(await decision(cleo), ["awarded", "Dee", "shown at the desk, with another map"]);
  await press("k");
  await showing(page, cleo);
  assert.match(await standing(), /not awarded decided: awarded against the proposal by Dee, .*“shown at the desk, with another map”/);
});

test("times are shown in the browser's time zone", async () => {
  const time = page.locator(".standing time");
  const at = new Date(await time.getAttribute("datetime"));
  const here = at.toLocaleTimeString("en-GB", { timeZone: zone, timeStyle: "short" });
  assert.ok((await time.textContent()).endsWith(here), await time.textContent());
});

test("a decision that is turned round asks whether the comment still fits", async () => {
  await click("[data-act=notYet]");
  assert.equal(await page.locator("#ask h2").textContent(), "Does your comment still fit?");
  assert.equal(await page.locator("#ask-why").inputValue(), "shown at the desk, with another map");
  await page.locator("#ask-why").fill("");
  await press("Enter");
  await showing(page, dai);
  assert.deepEqual(await decision(cleo), ["notYet", "Dee", ""]);
});

test("undo takes the last decision back, and says which", async () => {
  await press("u");
  await showing(page, cleo);
  assert.match(await standing(), /decided: awarded against the proposaltaken back: not yet by Dee/);
  assert.deepEqual(await decision(cleo), ["awarded", "Dee", "shown at the desk, with another map"]);
  await click("[data-act=undo]");
  await page.waitForFunction(() => !document.querySelector(".standing").textContent.includes("decided:"));
  await saved(page);
  assert.match(await standing(), /^proposed: not awardedtaken back: awarded by Dee, /);
  assert.deepEqual(await decision(cleo), ["", "", ""]);
  await press("n");
  await showing(page, dai);
  assert.deepEqual(await decision(cleo), ["notYet", "Dee", ""]);
});

test("a comment takes over what was found, is kept, and is taken back", async () => {
  const messages = await page.locator("main .card.fail > .message").allTextContents();
  assert.equal(messages.length, 1);
  const text = page.locator("#comment textarea");
  await click("[data-act=comment]");
  await click("#comment [data-act=quote]");
  await click("#comment [data-act=quote]");
  assert.equal(await text.inputValue(), messages[0], "once");
  await click("#comment [value=cancel]");
  assert.deepEqual(await decision(dai), ["", "", ""]);
  await press("c");
  assert.equal(await text.inputValue(), "", "what was cancelled is gone");
  await page.keyboard.type("Nearly.");
  await click("#comment [data-act=quote]");
  await page.keyboard.press("Control+Enter");
  used.add("key Ctrl").add("key Enter");
  assert.deepEqual(await decision(dai), ["", "Dee", `Nearly.\n\n${messages[0]}`]);
  assert.equal(await heading(), dai, "a comment does not go on");
  assert.match(await standing(), /^proposed: not awarded commented by Dee, .*“Nearly\./);
  await press("u");
  await page.waitForFunction(() => document.querySelector(".standing").textContent.includes("comment taken back"));
  assert.deepEqual(await decision(dai), ["", "", ""]);
  await press("c");
  await page.keyboard.type("See line 7.");
  await click("#comment [value=save]");
  assert.deepEqual(await decision(dai), ["", "Dee", "See line 7."]);
});

test("nothing is offered where nothing was found", async () => {
  await open(eve);
  await press("c");
  assert.ok(await page.locator("#comment [data-act=quote]").isDisabled());
  assert.equal(await page.locator("#comment .offer").count(), 0);
  await page.keyboard.type("Well done, {name}.");
  await click("#comment [data-act=keepWords]");
  await page.getByText("Saved for the tickers of this class.").waitFor();
  await press("Escape");
  assert.equal(await dialog(), "");
});

test("what is filtered is what keys walk through", async () => {
  await press("/");
  await page.keyboard.type("inverted-u");
  assert.deepEqual(await listed(), [bo, mia]);
  assert.equal(await page.locator(".shown").textContent(), "2 of 14 shown");
  await press("Enter");
  await showing(page, bo);
  await page.locator("main").focus();
  await press("j");
  await showing(page, mia);
  await press("n");
  await page.getByRole("heading", { name: "All that the list shows are decided" }).waitFor();
  assert.deepEqual(await decision(mia), ["notYet", "Dee", ""]);
  await click("[data-act=wholeList]");
  assert.deepEqual(await listed(), names);
  assert.equal(await page.locator("#find").inputValue(), "");
  await shown(page);
  await press("/");
  await page.keyboard.type("nothing like it");
  assert.deepEqual(await listed(), []);
  await press("Escape");
  assert.deepEqual(await listed(), names);
});

test("each filter lists what it says, and letters stay keys while it has the focus", async () => {
  const rows = onDisk(out);
  const fits = {
    all: () => true,
    undecided: ({ ruling }) => ruling === "",
    overruled: ({ verdict, ruling }) => verdict === "notAwarded" && ruling === "awarded",
    decidedAwarded: ({ ruling }) => ruling === "awarded",
    decidedNotYet: ({ ruling }) => ruling === "notYet",
    bulk: () => false,
    changed: () => false,
    commented: ({ comment }) => comment !== "",
  };
  for (const kind of await page.locator("#show option").evaluateAll((all) => all.map((one) => one.value))) {
    await page.locator("#show").selectOption(kind);
    const wanted = names.filter((name) => (fits[kind] ?? (({ verdict }) => verdict === kind))(rows[name]));
    assert.deepEqual(await listed(), wanted, kind);
    used.add(`filter ${kind}`);
  }
  await page.locator("#show").selectOption("all");
  await open(cleo);
  await page.locator("#show").selectOption("notAwarded");
  await page.locator("#show").focus();
  await press("j");
  for (const name of names.filter((one) => rows[one].verdict === "notAwarded" && rows[one].ruling === "")) {
    await showing(page, name);
    await press("n");
  }
  await page.getByRole("heading", { name: "All that the list shows are decided" }).waitFor();
  await saved(page);
  for (const [name, { verdict, ruling }] of Object.entries(onDisk(out)))
    assert.equal(ruling === "notYet", verdict === "notAwarded", name);
  assert.equal(await page.locator("#show").inputValue(), "notAwarded");
  await page.locator("#show").selectOption("undecided");
  assert.ok((await listed()).every((name) => fits.undecided(onDisk(out)[name])));
  await page.locator("#show").selectOption("all");
});

test("the summary decides nothing, and leads to what it names", async () => {
  await click("[data-act=summary]");
  assert.equal(await heading(), "How far you are");
  const before = onDisk(out);
  for (const act of ["award", "notYet", "comment"]) assert.ok(await isDisabled(act), act);
  for (const key of ["a", "n", "c"]) await press(key);
  assert.equal(await dialog(), "");
  assert.deepEqual(onDisk(out), before);
  assert.deepEqual(await page.locator("caption").allTextContents(), ["Who decided", "Most frequent findings", "Still open"],
    "no table is empty");
  assert.deepEqual(await accessibilityFaults(page), []);
  await click("main table button >> text=Fay Wu");
  await showing(page, fay);
  await press("s");
  assert.equal(await heading(), "How far you are");
  await click("[data-act=back]");
  await showing(page, fay);
  await click("[data-act=next]");
  await shown(page, fay);
  assert.equal(onDisk(out)[await heading()].ruling, "");
});

test("a compiler's error stands beside the student's line", async () => {
  await open(gil);
  const excerpt = page.locator("#compiler .remark").first();
  assert.match(await excerpt.textContent(), /line 34: .*Bw/);
  assert.match(await excerpt.locator("mark").textContent(), /34 .*return \(normal - Bu \* Pu - Bw \* Pv\)/);
});

test("the line of a compile error is in view, and takes a comment by keys alone", async () => {
  await press("l");
  const line = page.locator(".code .line.error");
  assert.equal(await line.getAttribute("data-line"), "34");
  assert.match(await line.locator(".said.error").first().textContent(), /'Bw' was not declared/);
  assert.equal(await page.evaluate(() => document.activeElement.closest(".line").dataset.line), "34");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("ArrowUp");
  await press("Enter");
  assert.equal(await page.locator("#comment h2").textContent(), "BumpySphere.cpp, line 34");
  await page.keyboard.type("`Bw` in line {line}, {name}?");
  await page.locator("#comment .preview code").waitFor();
  await page.keyboard.press("Control+Enter");
  assert.match(await line.locator(".said.note").textContent(), /Bw.* in line 34, Gil Mor\?/);
  await saved(page);
  const { submissions } = await (await fetch(`${session.address}class`)).json();
  const [note] = submissions.find((one) => one.name === gil).decision.notes;
  assert.deepEqual([note.file, note.line, note.text], ["BumpySphere.cpp", 34, "`Bw` in line 34, Gil Mor?"]);
  assert.match(note.code, /Bw \* Pv/);
});

test("groups lead to a contact sheet, which decides nothing by itself", async () => {
  const before = onDisk(out);
  await click("[data-act=groups]");
  assert.match(await heading(), /^\d+ groups$/);
  await press("g");
  await page.getByRole("button", { name: "Contact sheet: bump.inverted-u" }).click();
  assert.deepEqual(await listed(), [bo, mia]);
  assert.deepEqual(await page.locator(".sheet-card label").allTextContents(), [` ${bo}`, ` ${mia}`]);
  await click("#whole");
  await press("v");
  assert.equal(await page.locator(".sheet-card").count(), names.length);
  await click(".class [data-act=sheet]");
  assert.deepEqual(await accessibilityFaults(page), []);
  assert.deepEqual(onDisk(out), before);
});

test("the full report opens in another tab, by button and key", async () => {
  await open(gil);
  for (const way of [() => click("[data-act=report]"), () => press("o")]) {
    const opened = browser.context.waitForEvent("page");
    await way();
    const report = await opened;
    await report.getByRole("heading", { level: 1 }).waitFor();
    assert.match(await report.getByRole("heading", { level: 1 }).textContent(), /Gil Mor_1007/);
    await report.close();
  }
  assert.equal(await heading(), gil, "and this tab stays");
});

test("pictures blink, lie side by side or one over the other, and zoom", async () => {
  await open(bo);
  const viewer = page.locator(".viewer").first();
  const showingWhat = () => viewer.locator(".showing").textContent();
  const zoom = () => viewer.locator("output").textContent();
  await press("b");
  assert.equal(await showingWhat(), "Showing: submitted");
  await click(".viewer [data-act=blink]");
  assert.equal(await showingWhat(), "Showing: expected");
  await click(".viewer [data-act=over]");
  await viewer.locator("input[type=range]").fill("30");
  assert.equal(await showingWhat(), "Showing: expected | submitted");
  await click(".viewer [data-act=side]");
  assert.equal(await showingWhat(), "");
  await press("+");
  await click(".viewer [data-act=in]");
  assert.equal(await zoom(), "4×");
  await press("−");
  await click(".viewer [data-act=out]");
  assert.equal(await zoom(), "1×");
  await viewer.locator("input[type=range]").focus();
  await press("s"); // a slider has no letters
  assert.equal(await heading(), "How far you are");
});

test("the normals of a failed T1 are drawn, and the drawing turns", async () => {
  await open(bo);
  const drawing = page.locator(".ray-figure").first();
  assert.match(await drawing.locator(".ray-story").textContent(), /along u.*, 0 of 13 normals lean away from the brighter side/);
  const canvas = drawing.locator(".ray-stage canvas");
  await canvas.scrollIntoViewIfNeeded();
  const seen = () => canvas.evaluate((one) => one.toDataURL());
  for (const act of ["left", "up", "in", "home", "right", "down", "out"]) {
    const earlier = await seen();
    await click(`.ray-tools [data-act=${act}]`);
    await page.waitForFunction((last) => document.querySelector(".ray-figure .ray-stage canvas").toDataURL() !== last, earlier);
  }
});

test("of two who decide, the second says whose holds", async () => {
  await open(jon);
  await page.route(/\/class\?/, () => {}); // this page gets no news of the other ticker
  const other = await openSession(browser, session);
  await other.page.getByLabel("You are").fill("Eli");
  const decideFirst = async (name) => {
    await other.page.locator(".list button", { hasText: name }).click();
    await showing(other.page, name);
    await other.page.keyboard.press("a");
    await saved(other.page);
  };
  await decideFirst(jon);
  await press("n");
  await page.keyboard.type("the picture is another one's");
  await press("Enter");
  await page.locator("#conflict[open]").waitFor();
  assert.match(await page.locator("#conflict .words").textContent(),
    /^Eli decided about Jon Poe_1010 meanwhile: awarded\. You said: not yet \(“the picture is another one's”\)\.$/);
  await click("#conflict [value=theirs]");
  assert.deepEqual(await decision(jon), ["awarded", "Eli", ""]);
  await press("u");
  await showing(page, jon);
  assert.match(await standing(), /nothing taken back: decided again meanwhile by Eli/);
  assert.deepEqual(await decision(jon), ["awarded", "Eli", ""]);
  await open(eve);
  await decideFirst(eve);
  await press("n");
  await page.keyboard.type("copied");
  await press("Enter");
  await page.locator("#conflict[open]").waitFor();
  await click("#conflict [value=mine]");
  await page.waitForFunction(() => !document.querySelector("dialog[open]"));
  assert.deepEqual(await decision(eve), ["notYet", "Dee", "copied"]);
  assert.deepEqual(other.problems, []);
  await other.page.close();
  await page.unroute(/\/class\?/);
});

test("the help lists the keys, and these tests have used every button, filter and key", async () => {
  await press("?");
  assert.equal(await dialog(), "help");
  const told = await page.locator("#help kbd").allTextContents();
  await click("#help button");
  await click("[data-act=help]");
  await press("Escape");
  assert.equal(await dialog(), "");
  await open(bo);
  const buttons = await page.locator("button:not(.list button, .link, .at, .offers button, #group button, [data-act=list])").evaluateAll((all) => all.map((button) =>
    `${button.closest("dialog")?.id || "page"}: ${button.dataset.act || button.value || "close"}`));
  const filters = await page.locator("#show option").evaluateAll((all) => all.map(({ value }) => `filter ${value}`));
  const keys = [...new Set(told)].map((key) => `key ${key === "Esc" ? "Escape" : key}`);
  const unused = [...new Set([...buttons, ...filters, ...keys])].filter((one) => !used.has(one));
  assert.deepEqual(unused, []);
});

test("the last decision is followed by the summary, and the session's end by the table on disk", async () => {
  for (const [name, { verdict, ruling }] of Object.entries(onDisk(out))) {
    if (ruling !== "") continue;
    await open(name);
    await press(verdict === "notAwarded" || name === noa ? "n" : "a");
  }
  await page.getByRole("heading", { name: "All are decided" }).waitFor();
  assert.ok(await isDisabled("next"));
  assert.equal(await page.locator(".count").textContent(), "14 of 14 decided");
  await open(kay); // a tick against the proposal, for what the student reads
  await press("a");
  await page.keyboard.type("you measured from the corner on purpose");
  await press("Enter");
  const rows = (await saved(page), onDisk(out));
  assert.deepEqual(problems.filter((one) => !/status of 409/.test(one)), []); // two decisions came after another ticker's
  await page.setViewportSize({ width: 420, height: 850 });
  assert.equal(await overflow(page), 0);
  await page.close();
  rmSync(join(out, "summary.csv"));
  await session.kill("SIGINT");
  assert.deepEqual(rowsOf(readFileSync(join(out, "summary.csv"), "utf8")), rows);
  assert.ok(Object.values(rows).every(({ ruling }) => ruling !== ""));
});

test("the student reads what the ticker decided, and why", () => {
  execFileSync(ticker, ["report", out, "--format", "gradescope", "--submission", kay, "--quiet"]);
  const { output, score } = JSON.parse(readFileSync(join(out, kay, "gradescope.json"), "utf8"));
  assert.equal(score, 1);
  assert.match(output, /^Tick awarded by your ticker, against the automatic check\./);
  assert.match(output, /Your ticker says: you measured from the corner on purpose/);
});
