"use strict";
const body = document.querySelector("tbody");
const rows = [...body.rows];
const controls = {};
for (const name of ["search", "verdict", "finding"]) controls[name] = document.getElementById(name);
const shown = document.getElementById("shown");
const chips = [...document.querySelectorAll("button[data-verdict], button[data-finding]")];
const kindOf = (chip) => (chip.dataset.finding ? "finding" : "verdict");

/// The text that the search looks through, without the words that every row has.
const textOf = (row) => [...row.cells].map((cell) => (cell.querySelector("a") ?? cell).textContent)
  .concat(row.dataset.findings).join(" ").toLowerCase();

function filter() {
  const { search, verdict, finding } = controls;
  const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  let count = 0;
  for (const row of rows) {
    const text = textOf(row);
    row.hidden = !(words.every((word) => text.includes(word)) &&
      (!verdict.value || row.dataset.verdict === verdict.value) &&
      (!finding.value || row.dataset.findings.split(" ").includes(finding.value)));
    if (!row.hidden) count += 1;
  }
  for (const chip of chips) {
    const kind = kindOf(chip);
    chip.setAttribute("aria-pressed", String(chip.dataset[kind] === controls[kind].value));
  }
  const all = `${rows.length} submission${rows.length === 1 ? "" : "s"}`;
  shown.textContent = count === rows.length ? all : `${count} of ${all}`;
  remember();
}

/// Stores the filters in the address, so that going back from a report, or opening a link, restores them.
function remember() {
  const state = new URLSearchParams();
  for (const [name, control] of Object.entries(controls)) if (control.value) state.set(name, control.value);
  history.replaceState(null, "", state.size || [...state].length ? `#${state}` : location.pathname + location.search);
}

function recall() {
  const state = new URLSearchParams(location.hash.slice(1));
  for (const [name, control] of Object.entries(controls)) control.value = state.get(name) || "";
  filter();
}

for (const control of Object.values(controls)) control.addEventListener("input", filter);
for (const chip of chips)
  chip.addEventListener("click", () => {
    const kind = kindOf(chip);
    controls[kind].value = controls[kind].value === chip.dataset[kind] ? "" : chip.dataset[kind];
    filter();
  });
document.getElementById("clear").addEventListener("click", () => {
  for (const control of Object.values(controls)) control.value = "";
  filter();
});
document.addEventListener("keydown", (event) => {
  if (event.key !== "/" || event.target.closest("input, select")) return;
  event.preventDefault();
  controls.search.focus();
});

const heads = [...document.querySelectorAll("thead th")];
for (const [index, head] of heads.entries()) {
  head.querySelector("button")?.addEventListener("click", () => {
    const up = head.getAttribute("aria-sort") !== "ascending";
    for (const other of heads) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", up ? "ascending" : "descending");
    const key = (row) => row.cells[index].dataset.key ?? row.cells[index].textContent.trim();
    rows.sort((a, b) => key(a).localeCompare(key(b), undefined, { numeric: true }) * (up ? 1 : -1));
    body.append(...rows);
  });
}
recall();
