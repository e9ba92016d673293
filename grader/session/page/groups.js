// Groups of similar submissions, and the contact sheet, on which many are decided at once.
import { $, badge, button, counted, make, soft, words } from "./dom.js";
import { decidesAbout } from "./decide.js";
import { entries, gradingOf, isOpen, shown, standing, watch } from "./model.js";
import { changesOf, filter, findingsOfGroup, groupOf, listed, setFilter } from "./list.js";
import { ask } from "./server.js";
import { tell } from "./submission.js";
import { fill, open, register, viewName } from "./views.js";

// --- groups --------------------------------------------------------------------------------------

let counts = []; // [{place, members}] of the groups that are shown

function showCount({ place, members }) {
  const done = members.filter(({ name }) => !isOpen(name)).length;
  place.textContent = `${counted(members.length, "submission")}, ${done} decided`;
}

function card(key, members) {
  const [first] = members;
  const count = { place: make("p"), members };
  counts.push(count);
  showCount(count);
  const ids = [...new Set(first.findings)];
  return make("li", { class: `card group ${first.verdict}` },
    make("p", { class: "chips" }, badge(first.verdict), soft(`option ${first.option}`)),
    make("h2", {}, ids.length > 0 ? ids.join(", ") : "nothing was found"),
    ...changesOf(first).map((change) => make("p", {}, soft("mended by "), make("code", {}, change))),
    count.place,
    button("Contact sheet", () => { setFilter({ group: key }); open("sheet"); },
      { "aria-label": `Contact sheet: ${ids.join(", ") || words[first.verdict]}` }));
}

function showGroups() {
  if (filter.group) setFilter({ group: "" });
  counts = [];
  const groups = new Map();
  for (const name of listed()) {
    const entry = entries.get(name);
    const key = groupOf(entry);
    groups.set(key, [...(groups.get(key) ?? []), entry]);
  }
  const sorted = [...groups].sort((one, other) => other[1].length - one[1].length);
  fill(make("h1", {}, counted(sorted.length, "group")),
    make("p", {}, "Submissions in a group have the same findings and, where edits were looked for, are mended by the same edit. ",
      button(`Contact sheet of all ${listed().length} listed`, () => open("sheet"))),
    make("ul", { class: "groups" }, ...sorted.map(([key, members]) => card(key, members))));
  tell(soft("A contact sheet shows everybody's picture; there all are decided at once."));
}

// --- the contact sheet ---------------------------------------------------------------------------

let cards = new Map(); // name -> {element, box, state, ruling, isSeen}
const picked = () => [...cards].filter(([, { box }]) => box.checked).map(([name]) => name);

const picture = (address, what, name) =>
  make("figure", {}, make("img", { src: address, alt: `${what}, ${name}`, loading: "lazy" }), make("figcaption", {}, what));

async function addPictures(place, entry) {
  const { renders = [], told = "", error = "" } = await ask(`pictures?name=${encodeURIComponent(entry.name)}`);
  shown.set(entry.name, { files: entry.files, grading: gradingOf(entry) });
  const [render] = renders;
  place.replaceChildren(...(render
    ? [...(render.reference ? [picture(render.reference, "expected", entry.shown)] : []), picture(render.image, "submitted", entry.shown)]
    : [make("div", { class: "soft" }, error || "No picture.")]));
  if (!render) place.insertAdjacentHTML("beforeend", told); // made by the session, which escapes it
}

/// Records which submissions were visible: a bulk decision needs all of them.
const sight = new IntersectionObserver((seen) => {
  for (const { isIntersecting, target } of seen) {
    if (!isIntersecting) continue;
    const known = cards.get(target.dataset.name);
    if (!known || known.isSeen) continue;
    known.isSeen = true;
    addPictures($(".pair", target), entries.get(target.dataset.name));
  }
  showPicked();
}, { threshold: 0.35 });

/// Shows a card's decision. One that comes takes the tick away: a bulk decision is about what is open.
function showDecision(name) {
  const card = cards.get(name);
  const { ruling, bulk } = standing(name);
  const said = ruling === "undecided" ? [entries.get(name).verdict] : [ruling, `${words[ruling]}${bulk ? ", in bulk" : ""}`];
  card.state.replaceChildren(badge(...said));
  if (ruling !== "undecided" && ruling !== card.ruling) card.box.checked = false;
  card.ruling = ruling;
}

function sheetCard(name) {
  const entry = entries.get(name);
  const box = make("input", { type: "checkbox" });
  box.checked = isOpen(name);
  box.addEventListener("change", showPicked);
  const state = make("span");
  const element = make("li", { class: `card sheet-card ${entry.verdict}`, "data-name": name },
    make("p", { class: "row" }, make("label", {}, box, ` ${entry.shown}`), make("span", { class: "grow" }), state),
    make("div", { class: "pair" }, soft("...")),
    button("Open", () => open("submission", { name }), { "aria-label": `Open ${entry.shown}` }));
  cards.set(name, { element, box, state, isSeen: false });
  showDecision(name);
  sight.observe(element);
  return element;
}

function showPicked() {
  if (viewName() !== "sheet") return;
  const unseen = picked().filter((name) => !cards.get(name).isSeen).length;
  tell(`${picked().length} of ${cards.size} listed are ticked${unseen > 0 ? `; ${unseen} not looked at yet: scroll on` : ""}`);
}

function showSheet() {
  sight.disconnect();
  cards = new Map();
  const ids = findingsOfGroup(filter.group).join(", ");
  fill(make("h1", {}, `Contact sheet: ${filter.group ? ids || "nothing was found" : "all that the list shows"}`),
    make("p", {}, "Award and Not yet decide about all that are ticked, once each of them was on the screen. ",
      button("Tick all undecided", () => pick(isOpen)), " ", button("Tick none", () => pick(() => false)), " ",
      button("Groups", () => open("groups"))),
    make("ul", { class: "sheet" }, ...listed().map(sheetCard)));
  $("main").focus({ preventScroll: true });
  showPicked();
}

/// Follows other tickers and the grading: new decisions on the cards, and cards of submissions that have come. No
/// card moves or goes.
function followClass() {
  for (const name of cards.keys()) showDecision(name);
  let next = null;
  for (const name of listed().reverse()) {
    if (!cards.has(name)) $(".sheet").insertBefore(sheetCard(name), next);
    next = cards.get(name).element;
  }
  showPicked();
}

function pick(isPicked) {
  for (const [name, { box }] of cards) box.checked = isPicked(name);
  showPicked();
}

/// The ticked names; none until each of them was visible.
function ready() {
  const names = picked();
  const unseen = names.find((name) => !cards.get(name).isSeen);
  if (unseen === undefined) return names;
  cards.get(unseen).element.scrollIntoView({ block: "start" });
  return [];
}

export function watchGroups() {
  register("groups", { show: showGroups, listChanged: showGroups });
  register("sheet", { show: showSheet, listChanged: showSheet });
  decidesAbout(ready);
  watch((names) => {
    if (names !== null) return; // this page's own decisions: the view is drawn again
    if (viewName() === "sheet") followClass();
    if (viewName() === "groups") counts.forEach(showCount);
  });
}
