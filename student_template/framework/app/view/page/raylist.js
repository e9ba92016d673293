// The list of a drawing's rays, one line each in words.

/// More lines than these come after the drawing, all but the first ones: they take longer than it.
const kMostLines = 400;
const kFirstLines = 60;

class RayList {
  constructor(list) {
    this.list = list;
    this.lines = [];
    this.rays = [];
  }

  show(rays) {
    this.id = RayList.count = (RayList.count || 0) + 1;
    this.rays = rays;
    this.lines = [];
    this.list.replaceChildren();
    this.list.hidden = rays.length === 0;
    if (rays.length <= kMostLines) return this.addUpTo(rays.length);
    this.addUpTo(kFirstLines);
    requestAnimationFrame(() => setTimeout(() => { if (this.rays === rays) this.addUpTo(rays.length); }));
  }

  addUpTo(count) {
    const first = this.lines.length;
    const added = this.rays.slice(first, count).map((ray, i) => this.lineOf(ray, first + i));
    this.lines.push(...added);
    this.list.append(...added);
  }

  lineOf(ray, index) {
    const line = document.createElement("li");
    line.id = `ray-${this.id}-${index}`;
    line.dataset.ray = index;
    line.className = `ray-${ray.k}`;
    line.setAttribute("role", "option");
    line.setAttribute("aria-selected", "false");
    line.style.paddingLeft = `${0.5 + this.depthOf(ray)}rem`;
    line.textContent = ray.t;
    return line;
  }

  /// How many rays led to this one.
  depthOf(ray) { return ray.p >= 0 ? 1 + this.depthOf(this.rays[ray.p]) : 0; }

  /// Highlights a line; -1: none.
  choose(index) {
    if (index >= this.lines.length) this.addUpTo(this.rays.length);
    this.list.querySelector("[aria-selected=true]")?.setAttribute("aria-selected", "false");
    const line = this.lines[index];
    if (!line) return this.list.removeAttribute("aria-activedescendant");
    this.list.setAttribute("aria-activedescendant", line.id);
    line.setAttribute("aria-selected", "true");
    this.list.scrollTop = line.offsetTop - this.list.clientHeight / 2;
  }

  /// The index that a key leads to from the highlighted line; undefined for other keys.
  after(key) {
    const at = this.lines.findIndex((line) => line.getAttribute("aria-selected") === "true");
    const last = this.rays.length - 1;
    return last < 0 ? undefined
      : { ArrowDown: Math.min(last, at + 1), ArrowUp: Math.max(0, at - 1), Home: 0, End: last }[key];
  }
}
