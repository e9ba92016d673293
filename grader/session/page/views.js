// The views of the page, and the history of those that were shown.
import { $ } from "./dom.js";
import { model } from "./model.js";

const views = {}; // name -> {show(options), listChanged?()}
let place = { view: "summary", options: {} };
const trail = [];
const whenOpened = [];
let partsOfAddress = () => ({});

/// Registers a view: `show(options)` draws it; `listChanged()` is called when the list's contents change.
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

/// Draws the present view again.
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

/// Replaces the contents of the view, and scrolls to its top.
export function fill(...elements) {
  $("main").replaceChildren(...elements);
  window.scrollTo(0, 0);
}

export const describeAddress = (parts) => { partsOfAddress = parts; };

/// Writes view and filters into the address, so that tickers of this session can share it.
export function writeAddress() {
  const address = new URLSearchParams(partsOfAddress());
  if (place.view === "submission") address.set("at", place.options.name);
  else address.set("view", place.view);
  history.replaceState(null, "", `#${address}`);
}
