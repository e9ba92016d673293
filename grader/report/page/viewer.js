"use strict";
// Shared by the report and the ticking session.
const clamp = (value, low, high) => Math.min(high, Math.max(low, value));

/// The pictures of one scene: side by side or one over the other, blinking, all zooming together.
class Viewer {
  constructor(section) {
    this.section = section;
    this.stage = section.querySelector(".stage");
    this.slider = section.querySelector("input[type=range]");
    this.status = section.querySelector(".showing");
    this.readout = section.querySelector(".readout");
    this.at = { x: 0.5, y: 0.5 };
    this.zoom = 1;
    this.slider.addEventListener("input", () => this.wipe(Number(this.slider.value)));
    for (const button of section.querySelectorAll("[data-act]"))
      button.addEventListener("click", () => this.act(button.dataset.act));
    this.stage.addEventListener("pointerdown", (event) => this.grab(event));
    this.stage.addEventListener("pointermove", (event) => this.drag(event));
    this.stage.addEventListener("pointerleave", () => this.readout.replaceChildren());
    this.stage.addEventListener("dblclick", (event) => this.magnify(2, this.place(event)));
    this.stage.addEventListener("wheel", (event) => this.roll(event), { passive: false });
    this.stage.addEventListener("keydown", (event) => this.move(event));
  }

  get over() {
    return this.section.classList.contains("over");
  }

  act(name) {
    if (name === "side") this.lay(false);
    if (name === "over") this.lay(true);
    if (name === "blink") this.wipe(this.over && Number(this.slider.value) === 100 ? 0 : 100);
    if (name === "in") this.magnify(2);
    if (name === "out") this.magnify(0.5);
  }

  /// One picture over the other, or side by side.
  lay(over) {
    this.section.classList.toggle("over", over);
    const share = Number(this.slider.value);
    const blinking = over && (share === 0 || share === 100);
    const pressed = { side: !over, over: over && !blinking, blink: blinking };
    for (const [name, on] of Object.entries(pressed))
      this.section.querySelector(`[data-act=${name}]`).setAttribute("aria-pressed", String(on));
    const shown = share === 0 ? "expected" : share === 100 ? "submitted" : "expected | submitted";
    this.status.textContent = over ? `Showing: ${shown}` : "";
  }

  /// Covered share of the expected picture, in percent.
  wipe(share) {
    this.slider.value = share;
    this.section.style.setProperty("--share", `${this.slider.value}%`);
    this.lay(true);
  }

  /// Position of the pointer in its frame, from 0 to 1; null outside of all frames.
  place(event) {
    // Not the event's target: a captured pointer has the stage for its target.
    const frame = document.elementFromPoint(event.clientX, event.clientY)?.closest(".frame");
    if (!frame || !this.stage.contains(frame)) return null;
    const box = frame.getBoundingClientRect();
    return { x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height, box, frame };
  }

  /// Zooms by a factor around the fixed point `fixed`.
  magnify(factor, fixed) {
    const before = this.zoom;
    this.zoom = clamp(before * factor, 1, 32);
    const keep = (place, at) => (place - ((place - at) / before + at) * this.zoom) / (1 - this.zoom);
    if (fixed && this.zoom > 1) this.look(keep(fixed.x, this.at.x), keep(fixed.y, this.at.y));
    this.section.style.setProperty("--zoom", this.zoom);
    this.section.classList.toggle("zoomed", this.zoom > 1);
    this.section.querySelector("output").textContent = `${this.zoom}×`;
  }

  look(x, y) {
    this.at = { x: clamp(x, 0, 1), y: clamp(y, 0, 1) };
    this.section.style.setProperty("--at-x", `${100 * this.at.x}%`);
    this.section.style.setProperty("--at-y", `${100 * this.at.y}%`);
  }

  grab(event) {
    const place = this.place(event);
    if (!place || event.button !== 0) return;
    this.stage.setPointerCapture(event.pointerId);
    const onMap = place.frame.closest(".flip, .z");
    const nearDivider = Math.abs(place.x - 1 + Number(this.slider.value) / 100) * place.box.width < 16;
    const wipes = this.over && !onMap && (this.zoom === 1 || nearDivider);
    this.dragged = { wipes, x: event.clientX, y: event.clientY, at: this.at, box: place.box };
    if (wipes) this.wipe(Math.round(100 * (1 - place.x)));
    const drop = () => { this.dragged = null; };
    for (const end of ["pointerup", "pointercancel"])
      this.stage.addEventListener(end, drop, { once: true });
  }

  drag(event) {
    const from = this.dragged;
    if (!from) return this.read(event);
    if (from.wipes)
      return this.wipe(Math.round(clamp(100 * (1 - (event.clientX - from.box.left) / from.box.width), 0, 100)));
    if (this.zoom === 1) return;
    const along = (now, start, size) => (now - start) / size / (1 - this.zoom);
    this.look(from.at.x + along(event.clientX, from.x, from.box.width),
      from.at.y + along(event.clientY, from.y, from.box.height));
  }

  roll(event) {
    const place = this.place(event);
    if (!event.ctrlKey || !place) return;
    event.preventDefault();
    this.magnify(event.deltaY < 0 ? 2 : 0.5, place);
  }

  move(event) {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!step || this.zoom === 1 || event.target !== this.stage) return;
    event.preventDefault();
    const size = 0.2 / (this.zoom - 1);
    this.look(this.at.x + step[0] * size, this.at.y + step[1] * size);
  }

  /// The pixel under the pointer and its colour in both pictures.
  read(event) {
    const place = this.place(event);
    if (!place) return this.readout.replaceChildren();
    const part = (at, seen) => clamp((seen - at) / this.zoom + at, 0, 0.999999);
    const x = part(this.at.x, place.x);
    const y = part(this.at.y, place.y);
    const parts = [];
    for (const name of ["expected", "submitted"]) {
      const image = this.section.querySelector(`.${name} img`);
      const colour = pixelOf(image, Math.floor(x * image.naturalWidth), Math.floor(y * image.naturalHeight));
      if (!colour) return;
      if (parts.length === 0)
        parts.push(`(${Math.floor(x * image.naturalWidth)}, ${Math.floor(y * image.naturalHeight)})`);
      const swatch = document.createElement("i");
      swatch.style.background = `rgb(${colour})`;
      parts.push(swatch, `${name} ${colour.join(" ")}`);
    }
    this.readout.replaceChildren(...parts);
  }
}

const canvases = new WeakMap();
function pixelOf(image, x, y) {
  if (!canvases.has(image)) {
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth;
    canvas.height = image.naturalHeight;
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    canvases.set(image, context);
  }
  try {
    return [...canvases.get(image).getImageData(x, y, 1, 1).data].slice(0, 3);
  } catch {
    return null; // a picture beside the page, which a browser does not let scripts read
  }
}

/// The viewer with the focus, or else the one in the middle of the window.
function viewerInSight(viewers) {
  const focused = viewers.find(({ section }) => section.contains(document.activeElement));
  const distance = ({ section }) => {
    const box = section.getBoundingClientRect();
    return Math.max(0, box.top - window.innerHeight / 2, window.innerHeight / 2 - box.bottom);
  };
  return focused || [...viewers].sort((a, b) => distance(a) - distance(b))[0];
}
