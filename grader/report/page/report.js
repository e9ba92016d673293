"use strict";
// Each pair of pictures: side by side or one over the other, blinking, both zooming together.
class Comparison {
  constructor(section) {
    this.section = section;
    this.pair = section.querySelector(".pair");
    this.slider = section.querySelector("input[type=range]");
    this.status = section.querySelector(".showing");
    this.at = { x: 50, y: 50 };
    this.zoom = 1;
    this.slider.addEventListener("input", () => this.wipe(Number(this.slider.value)));
    for (const button of section.querySelectorAll("[data-act]"))
      button.addEventListener("click", () => this.act(button.dataset.act));
    this.pair.addEventListener("pointermove", (event) => this.follow(event));
    this.pair.addEventListener("keydown", (event) => this.move(event));
  }

  button(act) {
    return this.section.querySelector(`[data-act=${act}]`);
  }

  act(name) {
    if (name === "over") this.lay(!this.section.classList.contains("over"));
    if (name === "blink") this.wipe(Number(this.slider.value) < 50 ? 100 : 0);
    if (name === "in") this.magnify(this.zoom * 2);
    if (name === "out") this.magnify(this.zoom / 2);
    this.button("blink").setAttribute("aria-pressed", String(name === "blink"));
  }

  /// One picture over the other, or side by side.
  lay(over) {
    this.section.classList.toggle("over", over);
    this.button("over").setAttribute("aria-pressed", String(over));
    this.status.textContent = over ? this.shown() : "";
  }

  /// How much of the submitted picture is over the expected one, in percent.
  wipe(share) {
    this.slider.value = share;
    this.section.style.setProperty("--share", `${share}%`);
    this.lay(true);
  }

  shown() {
    const share = Number(this.slider.value);
    if (share === 0) return "Showing: expected";
    if (share === 100) return "Showing: submitted";
    return "Left: expected, right: submitted";
  }

  magnify(zoom) {
    this.zoom = Math.min(16, Math.max(1, zoom));
    this.section.style.setProperty("--zoom", this.zoom);
    this.section.classList.toggle("zoomed", this.zoom > 1);
    this.section.querySelector("output").textContent = `${this.zoom}×`;
  }

  look(x, y) {
    this.at = { x: Math.min(100, Math.max(0, x)), y: Math.min(100, Math.max(0, y)) };
    this.section.style.setProperty("--at-x", `${this.at.x}%`);
    this.section.style.setProperty("--at-y", `${this.at.y}%`);
  }

  follow(event) {
    const frame = event.target.closest(".frame");
    if (!frame || this.zoom === 1) return;
    const box = frame.getBoundingClientRect();
    this.look((100 * (event.clientX - box.left)) / box.width, (100 * (event.clientY - box.top)) / box.height);
  }

  move(event) {
    const step = { ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, -10], ArrowDown: [0, 10] }[event.key];
    if (!step || this.zoom === 1) return;
    event.preventDefault();
    this.look(this.at.x + step[0] / this.zoom, this.at.y + step[1] / this.zoom);
  }
}

const comparisons = [...document.querySelectorAll(".compare")].map((section) => new Comparison(section));

/// The one with the focus in it, else the one in the middle of the window.
function current() {
  const focused = comparisons.find(({ section }) => section.contains(document.activeElement));
  const distance = ({ section }) => {
    const box = section.getBoundingClientRect();
    return Math.abs((box.top + box.bottom) / 2 - window.innerHeight / 2);
  };
  return focused || [...comparisons].sort((a, b) => distance(a) - distance(b))[0];
}

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const act = { b: "blink", o: "over", "+": "in", "=": "in", "-": "out" }[event.key.toLowerCase()];
  const comparison = act && current();
  if (!comparison) return;
  event.preventDefault();
  comparison.act(act);
});

// On paper nothing can be opened.
window.addEventListener("beforeprint", () => {
  for (const details of document.querySelectorAll("details")) details.open = true;
});
