// The summary: counts of decisions, by ruling and by ticker.
import { $, button, clock, countBy, make, table, words } from "./dom.js";
import { entries, isOverruled, model, standing, watch } from "./model.js";
import { listed, setFilter, showWholeList } from "./list.js";
import { goOn } from "./submission.js";
import { fill, open, register } from "./views.js";

function linkTo(name) {
  return button(entries.get(name).shown, () => open("submission", { name }), { class: "link" });
}

/// One row for each ticker: how many, how, and from when to when.
function tickers(decided) {
  const names = countBy(decided, (entry) => standing(entry.name).who || "no name");
  return names.map(([who, count]) => {
    const own = decided.filter((entry) => (standing(entry.name).who || "no name") === who);
    const times = own.map((entry) => standing(entry.name).when).filter(Boolean).sort();
    const number = (is) => String(own.filter(is).length);
    return [who, String(count), number(({ name }) => standing(name).ruling === "awarded"),
      number(({ name }) => standing(name).ruling === "notYet"), number(isOverruled),
      ...(times.length > 0 ? [clock(times[0]), clock(times.at(-1))] : ["", ""])];
  });
}

function drawn() {
  const all = model.names.map((name) => entries.get(name));
  const ruling = (entry) => standing(entry.name).ruling;
  const undecided = all.filter((entry) => ruling(entry) === "undecided");
  const isListDone = undecided.length > 0 && undecided.every((entry) => entry.row.hidden);
  return [make("h1", {}, undecided.length === 0 ? "All are decided"
    : listed().length === 0 ? "The list shows no submission" : isListDone ? "All that the list shows are decided" : "How far you are"),
    make("p", { class: "counts" }, ["awarded", "notYet", "undecided"]
      .map((word) => `${all.filter((entry) => ruling(entry) === word).length} ${words[word]}`).join(", "),
      ` of ${all.length}.`),
    make("p", { class: "counts proposed" }, `Proposed: ${countBy(all, (entry) => words[entry.verdict])
      .map(([word, count]) => `${count} ${count > 1 ? word.replace("needs", "need") : word}`).join(", ")}.`),
    ...(isListDone ? [make("button", { type: "button", "data-act": "wholeList" }, "Show the whole list")] : []),
    ...table("Who decided", ["Ticker", "Decisions", "Awarded", "Not yet", "Against the proposal", "From", "To"],
      tickers(all.filter((entry) => ruling(entry) !== "undecided"))),
    ...table("Decided against the proposal", ["Submission", "Proposed", "Decided", "Why"],
      all.filter(isOverruled).map((entry) => [linkTo(entry.name), words[entry.verdict], words[ruling(entry)], standing(entry.name).comment])),
    ...table("Most frequent findings", ["Finding", "Submissions"],
      countBy(all, (entry) => [...new Set(entry.findings)]).slice(0, 12).map(([id, count]) =>
        [button(id, () => { setFilter({ finding: id }); goOn(); }, { class: "link" }), String(count)])),
    ...table("Still open", ["Submission", "Proposed"],
      undecided.slice(0, 50).map((entry) => [linkTo(entry.name), words[entry.verdict]]))];
}

/// Draws the summary again where its words differ. The page stays where it is, and so does the focus.
function refresh() {
  const main = $("main");
  if (main.dataset.view !== "summary") return;
  const now = make("div", {}, ...drawn());
  if (main.innerHTML === now.innerHTML) return;
  const focused = main.contains(document.activeElement) ? document.activeElement.textContent : "";
  main.replaceChildren(...now.childNodes);
  if (focused) [...main.querySelectorAll("button")].find((one) => one.textContent === focused)?.focus({ preventScroll: true });
}

export function watchSummary() {
  register("summary", { show: () => fill(...drawn()) });
  watch(refresh);
}

export function wholeList() {
  showWholeList();
  goOn();
}
