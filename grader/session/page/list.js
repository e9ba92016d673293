// The list of submissions: search, filters and order, which are also in the page's address.
import { $, button, counted, make, words } from "./dom.js";
import { entries, isOpen, isOverruled, isPending, isStale, model, standing, watch } from "./model.js";
import { here, open, writeAddress } from "./views.js";

const decided = (ruling) => (entry) => standing(entry.name).ruling === ruling;
const proposed = (verdict) => (entry) => entry.verdict === verdict;
const shows = {
  all: () => true,
  undecided: ({ name }) => isOpen(name),
  needsReview: proposed("needsReview"), notGraded: proposed("notGraded"),
  awarded: proposed("awarded"), notAwarded: proposed("notAwarded"),
  decidedAwarded: decided("awarded"), decidedNotYet: decided("notYet"),
  overruled: isOverruled,
  bulk: ({ name }) => !isOpen(name) && standing(name).bulk !== "",
  commented: ({ name }) => standing(name).comment !== "" || standing(name).notes.length > 0,
  changed: isStale,
  similar: ({ similar }) => similar.length > 0,
};

const byText = (one, other) => one.localeCompare(other, undefined, { numeric: true });
const mostSimilar = ({ similar }) => Math.max(0, ...similar.map(({ percent }) => percent));
const sorts = {
  name: () => 0,
  verdict: (a, b) => byText(a.verdict, b.verdict),
  finding: (a, b) => byText(a.findings.join(" ") || "~", b.findings.join(" ") || "~"),
  when: (a, b) => byText(standing(b.name).when ?? "", standing(a.name).when ?? ""),
  similar: (a, b) => mostSimilar(b) - mostSimilar(a),
  graded: (a, b) => byText(b.gradedAt, a.gradedAt),
};

/// What proven edits change: "before → after".
export const changesOf = ({ proven = [] }) => proven.map(({ from, to }) => `${from} → ${to || "left out"}`);

/// The key of an entry's group: verdict, option and findings, and what proven edits change.
export const groupOf = (entry) => [[entry.verdict, entry.option, ...[...new Set(entry.findings)].sort()].join(" "),
  ...changesOf(entry)].join("\n");
export const findingsOfGroup = (group) => group.split("\n")[0].split(" ").slice(2);

const whole = { find: "", show: "all", finding: "", task: "", by: "", sort: "name", group: "" };
export const filter = { ...whole };
let order = []; // all names as they are sorted

function fits(entry) {
  const wanted = filter.find.trim().toLowerCase();
  return (shows[filter.show] ?? shows.all)(entry) &&
    (!filter.finding || entry.findings.includes(filter.finding)) &&
    (!filter.task || entry.tasks.includes(filter.task)) &&
    (!filter.by || (!isOpen(entry.name) && (standing(entry.name).who || "no name") === filter.by)) &&
    (!filter.group || groupOf(entry) === filter.group) &&
    (!wanted || entry.shown.toLowerCase().includes(wanted) || entry.findings.some((id) => id.includes(wanted)));
}

/// The names that the list shows, in its order.
export const listed = () => order.filter((name) => !entries.get(name).row.hidden);

/// The next undecided name of the list after the current one; continues at the list's beginning.
export function nextUndecided() {
  const from = order.indexOf(model.current);
  const isNext = (name) => name !== model.current && !entries.get(name).row.hidden && isOpen(name);
  return order.slice(from + 1).find(isNext) ?? order.slice(0, Math.max(from, 0)).find(isNext) ?? null;
}

// --- the rows ------------------------------------------------------------------------------------

function makeRow(name) {
  const entry = entries.get(name);
  entry.mark = make("span", { class: "mark", "aria-hidden": "true" });
  entry.told = make("span", { class: "unseen" }); // the mark and the colour in words
  entry.found = make("span", { class: "found soft" });
  entry.button = button([entry.mark, make("span", { class: "name" }, entry.shown), entry.told, entry.found],
    () => open("submission", { name }));
  entry.row = make("li", {}, entry.button);
}

function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export function showRow(name) {
  const entry = entries.get(name);
  const { ruling, bulk } = standing(name);
  const isWaiting = isPending(name);
  const sign = { awarded: "✓", notYet: "✗", undecided: "" }[ruling];
  Object.assign(entry.row.dataset, { verdict: entry.verdict, ruling });
  setText(entry.mark, isWaiting ? `${sign}…` : sign);
  const extra = [ruling !== "undecided" && bulk ? "in bulk" : "", isStale(entry) ? "changed since decided" : "",
    isWaiting ? "not saved yet" : ""].filter(Boolean).map((text) => `, ${text}`).join("");
  setText(entry.told, `, proposed: ${words[entry.verdict]}, ${words[ruling]}${extra} `);
  setText(entry.found, [...(isStale(entry) ? ["changed since decided"] : []), ...new Set(entry.findings)].join(" "));
  if (name === model.current) entry.button.setAttribute("aria-current", "true");
  else entry.button.removeAttribute("aria-current");
}

function arrange() {
  order = [...model.names].sort((a, b) => sorts[filter.sort](entries.get(a), entries.get(b)));
  const list = $(".list");
  const rows = order.map((name) => entries.get(name).row);
  if (rows.length !== list.children.length || rows.some((row, i) => row !== list.children[i])) list.replaceChildren(...rows);
}

/// The choices in the part that may be folded.
const folded = () => ["finding", "task", "by"].filter((key) => filter[key])
  .map((key) => controls[key].selectedOptions[0]?.textContent ?? filter[key]).join(", ");

export function filterList() {
  let shown = 0;
  for (const name of order) {
    const entry = entries.get(name);
    entry.row.hidden = !fits(entry);
    shown += entry.row.hidden ? 0 : 1;
  }
  const why = folded();
  setText($(".shown"), shown === order.length ? "" : `${shown} of ${order.length} shown${why && `: ${why}`}`);
  $("#whole").hidden = Object.keys(whole).every((key) => filter[key] === whole[key]);
  $("#group").hidden = !filter.group;
  setText($("#group span"), findingsOfGroup(filter.group).join(" ") || "no findings");
}

// --- the controls --------------------------------------------------------------------------------

const controls = { find: $("#find"), show: $("#show"), finding: $("#finding"), task: $("#task"), by: $("#by"), sort: $("#sort") };

function offer(select, options) {
  const texts = options.map(([value, text]) => [value, text ?? value]);
  const key = JSON.stringify(texts);
  if (select.dataset.options === key) return;
  select.dataset.options = key;
  const { value } = select;
  select.replaceChildren(...texts.map(([value, text]) => make("option", { value }, text)));
  select.value = value;
}

function offerFilters() {
  const all = [...entries.values()];
  const of = (list) => [...new Set(list)].sort(byText).map((one) => [one]);
  offer(controls.finding, [["", "any"], ...of([...all.flatMap((one) => one.findings), filter.finding].filter(Boolean))]);
  offer(controls.task, [["", "any"], ...of([...all.flatMap((one) => one.tasks), filter.task].filter(Boolean))
    .map(([one]) => [one, one.replace(":", " ").replace(/([a-z])([A-Z])/g, (_, a, b) => `${a} ${b.toLowerCase()}`)])]);
  offer(controls.by, [["", "anybody"], ...of([...all.filter((one) => !isOpen(one.name))
    .map((one) => standing(one.name).who || "no name"), filter.by].filter(Boolean))]);
}

/// Sets filters and shows the list by them.
export function setFilter(values) {
  Object.assign(filter, values);
  if (!sorts[filter.sort]) filter.sort = "name";
  offerFilters();
  for (const [key, control] of Object.entries(controls)) if (control.value !== filter[key]) control.value = filter[key];
  arrange();
  filterList();
  writeAddress();
}

export const showWholeList = () => setFilter(whole);

/// The filters in an address.
export const filterFrom = (address) =>
  Object.fromEntries(Object.keys(whole).map((key) => [key, address.get(key) ?? whole[key]]));
export const filterForAddress = () =>
  Object.fromEntries(Object.entries(filter).filter(([key, value]) => value !== whole[key]));

export function watchList() {
  for (const [key, control] of Object.entries(controls))
    control.addEventListener("input", () => { setFilter({ [key]: control.value }); here().listChanged?.(); });
  $("#group button").addEventListener("click", () => { setFilter({ group: "" }); here().listChanged?.(); });
  controls.find.addEventListener("keydown", (event) => {
    if (event.key === "Escape") { setFilter({ find: "" }); here().listChanged?.(); event.target.blur(); }
    if (event.key === "Enter" && listed().length > 0) open("submission", { name: listed()[0] });
  });
  watch((names) => {
    for (const name of model.names) if (!entries.get(name).row) makeRow(name);
    for (const name of names ?? model.names) showRow(name);
    if (names === null) offerFilters();
    if (names === null || filter.sort === "when") arrange();
    filterList();
  });
}

export function countText() {
  const done = model.names.filter((name) => !isOpen(name)).length;
  return { done, text: `${done} of ${model.names.length} decided`, all: counted(model.names.length, "submission") };
}
