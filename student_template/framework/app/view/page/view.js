// The page of tick1star --view: shows what the program tells, asks it what is clicked.
const byId = (id) => document.getElementById(id);
const token = location.pathname.split("/")[1];
const picture = new Picture(byId("picture"), byId("other"));
const mark = { x: 320, y: 240 };
let settings = null;
let firstSettings = null;
let question = null; // the last one, to be asked again when the code or a setting changes
let isAsking = false;
let areRaysOld = false; // the last question was about an earlier picture

const controls = [
  ["lightSize", "Light size", 0, 2, 0.05], ["shadowRays", "Shadow rays", 1, 100, 1],
  ["aperture", "Aperture", 0, 1, 0.01], ["focalPlane", "Focal plane", 0.5, 12, 0.05],
  ["dofRays", "Camera rays", 1, 200, 1], ["bounces", "Bounces", 0, 8, 1],
];

const rays = new RayView(byId("drawing"), { onPoint: (point) => ask("point", { x: point[0], y: point[1], z: point[2] }) });

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

const ended = "The viewer has ended. Start it again: it prints a new address.";

async function request(path, options) {
  const response = await fetch(path, options).catch(() => { throw new Error(ended); });
  if (!response.ok) throw new Error(await response.text());
  return response;
}

// ---- settings

/// An empty field changes nothing; when it loses the focus, it shows the setting in force again.
function listenTo(input, name) {
  input.dataset.setting = name;
  input.addEventListener("input", () => input.value && change({ [name]: input.value }));
  input.addEventListener("blur", () => { if (settings && !isSending) input.value = settings[name]; });
}

function addControls() {
  for (const [name, words, min, max, step] of controls) {
    const [range, number] = ["range", "number"].map((type) => element("input", { type, min, max, step }));
    number.removeAttribute("max"); // the program says what is too much
    range.setAttribute("aria-label", `${words}, as a slider`);
    number.setAttribute("aria-label", words);
    for (const input of [range, number]) listenTo(input, name);
    const parts = [element("span", { textContent: words }), range, number];
    if (name !== "bounces") for (const part of parts) part.dataset.of = "lens";
    byId("settings").append(...parts);
  }
  const seed = element("input", { type: "number", min: 0, step: 1, className: "wide" });
  seed.setAttribute("aria-label", "Seed");
  listenTo(seed, "seed");
  byId("settings").append(element("span", { textContent: "Seed" }), seed);
  byId("scene").addEventListener("change", () => change({ scene: byId("scene").value }));
  byId("defaults").addEventListener("click", () => change(firstSettings));
}

let waiting = null;
let isSending = false;
/// Sends the newest values alone: a slider moves faster than a picture can begin.
async function change(changes) {
  waiting = { ...waiting, ...changes };
  if (isSending) return;
  isSending = true;
  while (waiting) {
    const body = new URLSearchParams(waiting);
    waiting = null;
    try {
      await request("settings", { method: "POST", body, headers: { "X-Ticker": token } });
    } catch (error) {
      tell(error.message);
      if (settings) showSettings(settings);
    }
  }
  isSending = false;
}

function showSettings(now) {
  settings = now;
  for (const input of document.querySelectorAll("[data-setting]"))
    if (input !== document.activeElement || input.type === "range") input.value = now[input.dataset.setting];
}

// ---- pixels

/// A pixel or a point of a surface is drawn. One question at a time, then the newest; what is said about
/// another scene is dropped.
async function ask(kind, at, isAgain = false) {
  question = { kind, at, scene: settings?.scene };
  if (isAsking) return;
  isAsking = true;
  for (let asked = null; question && question !== asked; isAgain = true) {
    asked = question;
    try {
      const drawing = await (await request(`${asked.kind}?${new URLSearchParams(asked.at)}`)).json();
      if (asked.scene === settings?.scene) showRays(drawing, isAgain || asked.kind === "point");
    } catch (error) { tell(error.message); }
  }
  isAsking = false;
}

function showRays(drawing, keepsView) {
  const isFirst = byId("rays").hidden;
  byId("rays").hidden = false;
  rays.show(drawing, keepsView);
  if (isFirst) byId("rays").scrollIntoView({ block: "nearest" }); // who clicks once more knows where they are
  tell(drawing.about);
}

function forgetRays() {
  question = null;
  byId("rays").hidden = byId("mark").hidden = true;
  tell("");
}

function moveMark(x, y) {
  const { canvas } = picture;
  mark.x = Math.min(canvas.width - 1, Math.max(0, Math.floor(x)));
  mark.y = Math.min(canvas.height - 1, Math.max(0, Math.floor(y)));
  byId("mark").hidden = false;
  byId("mark").style.left = `${100 * (mark.x + 0.5) / canvas.width}%`;
  byId("mark").style.top = `${100 * (mark.y + 0.5) / canvas.height}%`;
}

function listenToPicture() {
  const { canvas } = picture;
  canvas.addEventListener("click", (event) => {
    const box = canvas.getBoundingClientRect();
    moveMark((event.clientX - box.left) / box.width * canvas.width, (event.clientY - box.top) / box.height * canvas.height);
    ask("pixel", { ...mark });
  });
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  canvas.addEventListener("keydown", (event) => {
    const step = steps[event.key];
    if (!step && event.key !== "Enter") return;
    event.preventDefault();
    const far = event.shiftKey ? 20 : 2;
    if (step) moveMark(mark.x + far * step[0], mark.y + far * step[1]);
    else { moveMark(mark.x, mark.y); ask("pixel", { ...mark }); }
    if (step) tell(`Pixel (${mark.x}, ${mark.y}): Enter shows its rays`);
  });
}

// ---- comparing

function compare() {
  const name = byId("compare").value;
  byId("wipe").hidden = !name;
  if (name === "pinhole" && !picture.kept.pinhole) fetchPinhole();
  else picture.compare(name);
}

let isFetching = false;
/// One request at a time, then one with the newest settings: a slider moves faster than a picture is rendered.
async function fetchPinhole() {
  if (isFetching) return;
  isFetching = true;
  for (let asked = null; byId("compare").value === "pinhole" && !picture.kept.pinhole && asked !== picture.number;) {
    asked = picture.number;
    const { width, height } = picture.canvas;
    try {
      const bytes = new Uint8Array(await (await request("pinhole")).arrayBuffer());
      if (asked === picture.number) picture.kept.pinhole = picture.imageOf(bytes, width, height);
    } catch (error) { tell(error.message); }
  }
  isFetching = false;
  if (picture.kept.pinhole) picture.compare(byId("compare").value);
}

function showCompare() {
  const before = byId("compare").querySelector("[value=before]");
  before.disabled = !picture.kept.before;
  if (before.disabled && before.selected) byId("compare").value = "";
  compare();
}

// ---- what the program tells

function tell(words) { byId("status").textContent = words; }

function showPicture(head) {
  const isNewScene = settings && settings.scene !== head.settings.scene;
  picture.begin(head, isNewScene);
  showSettings(head.settings);
  byId("done").value = 0;
  byId("stage").textContent = "";
  if (isNewScene) forgetRays();
  areRaysOld = question !== null;
  showCompare();
}

function showPiece(piece) {
  picture.add(piece);
  if (areRaysOld) { areRaysOld = false; ask(question.kind, question.at, true); } // the picture comes first
  const { at } = piece;
  byId("done").value = picture.share();
  byId("stage").textContent = at.stage || (at.last ? "done" : `${Math.max(1, Math.round(at.left))} s left`);
}

function show(news) {
  if (news.hasLens === false) for (const part of document.querySelectorAll("[data-of=lens]")) part.hidden = true;
  if (news.scenes)
    byId("scene").replaceChildren(...news.scenes.map((name) => element("option", { value: name, textContent: name })));
  if (news.started) firstSettings = news.started;
  if (news.picture) showPicture(news.picture);
  else if (news.scenes && settings) showSettings(settings);
  if (news.build) showBuild(news.build);
  if (news.tests) showTests(news.tests);
  if (news.trouble !== undefined) {
    byId("trouble").hidden = !news.trouble;
    byId("trouble").textContent = news.trouble;
  }
  for (const piece of news.pieces) showPiece(piece);
}

async function newsAfter(version) {
  try { return await (await request(`news?after=${version}`)).json(); } catch { return null; }
}

async function follow() {
  for (let version = 0; ;) {
    const news = await newsAfter(version);
    if (news && version === 0) tell("");
    if (news) { version = news.version; show(news); continue; }
    tell(ended);
    version = 0; // asked for all of it, a viewer that is back (after a laptop's sleep) answers at once
    await new Promise((done) => setTimeout(done, 2000));
  }
}

addControls();
listenToPicture();
byId("compare").addEventListener("change", compare);
byId("wipe").querySelector("input").addEventListener("input", (event) =>
  byId("other").style.setProperty("--share", `${event.target.value}%`));
follow();
