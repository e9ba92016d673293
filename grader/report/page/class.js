"use strict";
const body = document.querySelector("tbody");
const rows = [...body.rows];
const search = document.getElementById("search");
const verdict = document.getElementById("verdict");
const finding = document.getElementById("finding");
const shown = document.getElementById("shown");
const chips = [...document.querySelectorAll("[data-finding]")];

function filter() {
  const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  let count = 0;
  for (const row of rows) {
    const text = row.textContent.toLowerCase();
    const fits = words.every((word) => text.includes(word)) &&
      (!verdict.value || row.dataset.verdict === verdict.value) &&
      (!finding.value || row.dataset.findings.split(" ").includes(finding.value));
    row.hidden = !fits;
    if (fits) count += 1;
  }
  for (const chip of chips)
    chip.setAttribute("aria-pressed", String(chip.dataset.finding === finding.value));
  shown.textContent = count === rows.length ? `${count} submissions` : `${count} of ${rows.length} submissions`;
}
for (const control of [search, verdict, finding]) control.addEventListener("input", filter);
for (const chip of chips)
  chip.addEventListener("click", () => {
    finding.value = finding.value === chip.dataset.finding ? "" : chip.dataset.finding;
    filter();
  });
document.getElementById("clear").addEventListener("click", () => {
  for (const control of [search, verdict, finding]) control.value = "";
  filter();
});
// A browser may bring back what was typed before the page was loaded again.
filter();

for (const [index, head] of [...document.querySelectorAll("thead th")].entries()) {
  const button = head.querySelector("button");
  if (!button) continue;
  button.addEventListener("click", () => {
    const up = head.getAttribute("aria-sort") !== "ascending";
    for (const other of document.querySelectorAll("thead th")) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", up ? "ascending" : "descending");
    const key = (row) => row.cells[index].textContent.trim();
    rows.sort((a, b) => key(a).localeCompare(key(b), undefined, { numeric: true }) * (up ? 1 : -1));
    body.append(...rows);
  });
}
