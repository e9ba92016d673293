// What can fill the page, and where the ticker was.
import { $ } from "./dom.js";
import { model } from "./model.js";

const views = {}; // name -> {show(options), listChanged?(), keys?}
let place = { view: "summary", options: {} };
const trail = [];
const whenOpened = [];
let partsOfAddress = () => ({});

/// Takes in a view: `show(options)` fills the page; `listChanged()` is told when the list shows others.
export const register = (name, view) => { views[name] = view; };
export const onOpen = (work) => whenOpened.push(work);
export const here = () => views[place.view];
export const viewName = () => place.view;
export const canGoBack = () => trail.length > 0;

export function open(view, options = {}) {
  const isSame = place.view === view && place.options.name === options.name;
  if (!isSame && $("main").dataset.view) trail.push(place);
  enter(view, options);
}

export function goBack() {
  const before = trail.pop();
  if (before) enter(before.view, before.options);
}

/// Fills the page anew with what fills it.
export const again = () => enter(place.view, place.options);

function enter(view, options) {
  place = { view, options };
  const before = model.current;
  model.current = view === "submission" ? options.name : null;
  const main = $("main");
  main.dataset.view = view;
  main.classList.remove("loading");
  if (view !== "submission") delete main.dataset.name;
  views[view].show(options);
  for (const work of whenOpened) work(before);
  writeAddress();
}

/// Fills the page with elements, from its top.
export function fill(...elements) {
  $("main").replaceChildren(...elements);
  window.scrollTo(0, 0);
}

export const describeAddress = (parts) => { partsOfAddress = parts; };

/// The address says what the page shows, so that it can be shared with other tickers of this session.
export function writeAddress() {
  const address = new URLSearchParams(partsOfAddress());
  if (place.view === "submission") address.set("at", place.options.name);
  else address.set("view", place.view);
  history.replaceState(null, "", `#${address}`);
}
