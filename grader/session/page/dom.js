// Small functions that all modules of the page use.

export const $ = (selector, root = document) => root.querySelector(selector);
export const wait = (ms) => new Promise((done) => setTimeout(done, ms));

export const words = {
  awarded: "awarded", notAwarded: "not awarded", needsReview: "needs a look", notGraded: "not graded",
  notYet: "not yet", undecided: "undecided",
};

/// Makes an element: make("p", {class: "soft"}, "text", child, ...).
export function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

export const soft = (...children) => make("span", { class: "soft" }, ...children);

/// A verdict or ruling, coloured.
export const badge = (what, text = words[what]) => make("span", { class: `badge ${what === "notYet" ? "notAwarded" : what}` }, text);

/// A button with its click handler.
export function button(text, work, attributes = {}) {
  const element = make("button", { type: "button", ...attributes }, ...[text].flat());
  element.addEventListener("click", work);
  return element;
}

/// A UTC time in local time: without the date if it is today.
export function clock(when) {
  const at = new Date(when);
  const isToday = at.toDateString() === new Date().toDateString();
  const text = at.toLocaleString([], { ...(isToday ? {} : { dateStyle: "medium" }), timeStyle: "short" });
  return make("time", { datetime: when }, text);
}

/// A table in a list; an empty list without rows.
export function table(caption, head, rows) {
  if (rows.length === 0) return [];
  return [make("table", {}, make("caption", {}, caption),
    make("thead", {}, make("tr", {}, ...head.map((text) => make("th", { scope: "col" }, text)))),
    make("tbody", {}, ...rows.map((cells) => make("tr", {}, ...cells.map((cell) => make("td", {}, cell))))))];
}

/// How often each key occurs, the most frequent first. `keyOf` returns one key or several.
export function countBy(list, keyOf) {
  const counts = new Map();
  for (const one of list) for (const key of [keyOf(one)].flat()) counts.set(key, (counts.get(key) || 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1]);
}

export const counted = (count, what) => `${count} ${what}${count === 1 ? "" : "s"}`;
