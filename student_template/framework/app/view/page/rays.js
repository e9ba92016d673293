// A drawing of rays with its words: what turns, picks and highlights. Needs orbit.js, drawing.js,
// picking.js and raylist.js before it, and an element to fill.
class RayView {
  /// onPoint: what happens with a point of a surface that is picked, as a function of it; none: points
  /// cannot be picked.
  constructor(root, { onPoint } = {}) {
    this.onPoint = onPoint;
    root.classList.add("ray-view");
    root.parentElement.classList.add("ray-room");
    root.innerHTML = `<div class="ray-stage"><canvas tabindex="0" role="application"></canvas></div>
      <div class="ray-tools" role="group" aria-label="View"></div>
      <fieldset class="ray-legend"><legend>Shown</legend></fieldset>
      <div class="ray-faces"></div>
      <div class="ray-story"></div>
      <ol class="ray-list" role="listbox" tabindex="0" aria-label="Rays"></ol>`;
    for (const name of ["stage", "tools", "legend", "faces", "story"]) this[name] = root.querySelector(`.ray-${name}`);
    this.listBox = root.querySelector(".ray-list");
    this.list = new RayList(this.listBox);
    this.canvas = root.querySelector("canvas");
    this.drawing = new RayDrawing(this.canvas);
    this.addTools();
    this.listen();
    this.follow();
  }

  show(data, keepsView = false) {
    this.drawing.data = data;
    this.fillLegend();
    this.fillWords();
    const shown = data.rays.length ? `${data.rays.length} rays` : `${(data.normals || []).length} points`;
    this.canvas.setAttribute("aria-label", `${data.about}. ${shown} in 3-D: ` +
      "arrow keys turn the drawing, plus and minus come nearer and go away, 0 goes back");
    this.fit();
    this.drawing.show(data, keepsView);
    this.choose(-1);
  }

  addTools() {
    const tools = { left: ["\u2190", "Turn left"], right: ["\u2192", "Turn right"], up: ["\u2191", "Look from higher"],
      down: ["\u2193", "Look from lower"], in: ["+", "Nearer"], out: ["\u2212", "Further away"], home: ["\u2302", "First view"] };
    for (const [act, [sign, words]] of Object.entries(tools)) this.addButton(act, sign, words);
    if (!this.onPoint) return;
    this.addButton("point", "Light at the end of this ray", "");
    this.tools.lastChild.disabled = true;
  }

  addButton(act, sign, words) {
    const button = document.createElement("button");
    button.type = "button";
    button.dataset.act = act;
    button.textContent = sign;
    if (words) button.setAttribute("aria-label", button.title = words);
    button.addEventListener("click", () => this.act(act));
    this.tools.append(button);
  }

  act(act) {
    const { orbit } = this.drawing;
    const step = 0.12;
    const ray = this.drawing.data.rays[this.drawing.chosen];
    ({ left: () => orbit.turn(step, 0), right: () => orbit.turn(-step, 0), up: () => orbit.turn(0, step),
      down: () => orbit.turn(0, -step), in: () => this.comeNearer(1.25), out: () => orbit.zoomBy(0.8),
      home: () => this.drawing.frame(), point: () => ray && this.onPoint(ray.b) })[act]();
    this.redraw();
  }

  /// Comes nearer, to the end of the chosen ray where there is one.
  comeNearer(factor) {
    const { orbit, data, chosen } = this.drawing;
    if (data.rays[chosen]) orbit.approach(data.rays[chosen].b);
    orbit.zoomBy(factor);
  }

  redraw(isMoving = false) {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => { this.isAsked = false; this.drawing.draw(isMoving); });
  }

  listen() {
    const keys = { ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down", "+": "in", "=": "in",
      "-": "out", 0: "home" };
    this.canvas.addEventListener("keydown", (event) => {
      const act = !event.ctrlKey && !event.metaKey && !event.altKey && keys[event.key];
      if (!act) return;
      event.preventDefault();
      event.stopPropagation();
      this.act(act);
    });
    this.canvas.addEventListener("pointerdown", (event) => this.grab(event));
    this.canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const name of ["pointerup", "pointercancel"])
      this.canvas.addEventListener(name, (event) => this.letGo(event));
    this.canvas.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && document.activeElement !== this.canvas) return; // the page scrolls
      event.preventDefault();
      if (event.deltaY < 0) this.comeNearer(1.1);
      else this.drawing.orbit.zoomBy(1 / 1.1);
      this.redraw(true);
    }, { passive: false });
    this.listBox.addEventListener("click", (event) => {
      const line = event.target.closest("li");
      if (line) this.choose(Number(line.dataset.ray));
    });
    this.listBox.addEventListener("keydown", (event) => this.walk(event));
    this.legend.addEventListener("change", ({ target }) => {
      this.drawing.hidden[target.checked ? "delete" : "add"](target.value);
      this.redraw();
    });
  }

  grab(event) {
    if (event.button !== 0) return;
    this.canvas.setPointerCapture(event.pointerId);
    this.held = { x: event.clientX, y: event.clientY, moved: 0 };
  }

  move(event) {
    if (!this.held) return;
    const [dx, dy] = [event.clientX - this.held.x, event.clientY - this.held.y];
    this.held = { x: event.clientX, y: event.clientY, moved: this.held.moved + Math.abs(dx) + Math.abs(dy) };
    this.drawing.orbit.turn(-dx * 0.008, dy * 0.008);
    this.redraw(true);
  }

  letGo(event) {
    const wasClick = this.held && this.held.moved < 4 && event.type === "pointerup";
    this.held = null;
    if (wasClick) this.pick(event.offsetX, event.offsetY, event.shiftKey);
    this.redraw();
  }

  /// A click takes the ray there, else (or with Shift) the point of the surface there.
  pick(x, y, wantsSurface) {
    const ray = wantsSurface ? -1 : rayAt(this.drawing, x, y);
    const point = ray < 0 && this.onPoint && surfaceAt(this.drawing, x, y);
    if (point) this.onPoint(point);
    else this.choose(ray);
  }

  walk(event) {
    const to = this.list.after(event.key);
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    this.choose(to);
  }

  /// Highlights a ray and its line together; -1: none.
  choose(index) {
    this.drawing.chosen = index;
    this.list.choose(index);
    const ray = this.drawing.data.rays[index];
    const point = this.tools.querySelector("[data-act=point]");
    if (point) point.disabled = !ray || Boolean(ray.m);
    this.fillFaces(index);
    this.redraw();
  }

  fillLegend() {
    const { data, hidden } = this.drawing;
    this.legend.querySelectorAll("label").forEach((label) => label.remove());
    for (const [name, kind] of Object.entries(kRayKinds))
      this.addKind(name, kind, data.rays.filter((ray) => ray.k === name).length, hidden);
    for (const [name, kind] of Object.entries(kNormalKinds))
      this.addKind(`${name}Normal`, kind, (data.normals || []).filter((normal) => normal[name]).length, hidden);
  }

  addKind(name, kind, count, hidden) {
    if (count === 0) return;
    const label = document.createElement("label");
    const sign = `<svg viewBox="0 0 28 8" aria-hidden="true"><line x1="0" y1="4" x2="28" y2="4"
      stroke-dasharray="${kind.dash.join(" ")}" style="--light:${kind.light};--dark:${kind.dark}"/></svg>`;
    label.innerHTML = `<input type="checkbox" value="${name}"${hidden.has(name) ? "" : " checked"}>${sign}<span></span>`;
    label.lastChild.textContent = `${kind.name}: ${count}`;
    this.legend.append(label);
  }

  fillWords() {
    const { data } = this.drawing;
    this.story.replaceChildren(...data.words.map((words) => {
      const line = document.createElement("p");
      line.textContent = words;
      return line;
    }));
    this.list.show(data.rays);
  }

  /// The lens, and the lights as the hit of the chosen ray sees them (else the first hit).
  fillFaces(index) {
    const { data } = this.drawing;
    const chosen = data.rays[index];
    const first = data.rays.find((ray) => ray.l >= 0);
    let parent = chosen && chosen.l >= 0 ? chosen.p : index;
    if (!data.rays.some((ray) => ray.p === parent && ray.l >= 0)) parent = first ? first.p : -2;
    this.faces.replaceChildren();
    const starts = data.rays.filter((ray) => ray.k === "camera" && ray.p < 0);
    if (data.lens && starts.length > 1)
      this.addFace("The lens, and where rays start on it", { radius: data.lens.halfWidth, isSquare: true,
        points: starts.map(({ a, k }) => ({ x: a[0], y: a[1], k })) }, this.lensWords(starts));
    for (const { light, points } of lightFaces(data, parent)) {
      const arrive = points.filter(({ k }) => k === "arrives").length;
      this.addFace(`${light.name} as ${parent >= 0 ? "this hit" : "the point"} sees it`,
        { radius: light.radius, points }, `${arrive} of ${points.length} rays ${arrive === 1 ? "arrives" : "arrive"}`);
    }
  }

  lensWords(starts) {
    const most = 1.0001 * this.drawing.data.lens.halfWidth;
    const outside = starts.filter(({ a }) => Math.max(Math.abs(a[0]), Math.abs(a[1])) > most).length;
    return `${starts.length} rays${outside ? `, ${outside} of them outside the lens` : ""}`;
  }

  addFace(title, face, words) {
    const figure = document.createElement("figure");
    figure.innerHTML = `<canvas width="240" height="240" role="img"></canvas><figcaption></figcaption>`;
    figure.firstChild.setAttribute("aria-label", `${title}: ${words}`);
    figure.lastChild.textContent = `${title}: ${words}`;
    drawFace(figure.firstChild, face, this.drawing.isDark);
    this.faces.append(figure);
  }

  fit() {
    const { width, height } = this.canvas.getBoundingClientRect();
    if (width) this.drawing.resize(width, height, Math.min(2, window.devicePixelRatio || 1));
  }

  /// Follows the window's size and colours; paper is light. Ends when the drawing is taken off the page, which its
  /// size tells: otherwise the window would keep each drawing that it ever had.
  follow() {
    const colours = matchMedia("(prefers-color-scheme: dark)");
    const paper = matchMedia("print");
    const adapt = () => {
      this.drawing.isDark = colours.matches && !paper.matches;
      this.fillFaces(this.drawing.chosen);
      this.drawing.draw();
    };
    const size = new ResizeObserver(() => {
      if (this.canvas.isConnected) { this.fit(); this.drawing.draw(); return; }
      for (const media of [colours, paper]) media.removeEventListener("change", adapt);
      size.disconnect();
    });
    for (const media of [colours, paper]) media.addEventListener("change", adapt);
    size.observe(this.canvas);
    this.drawing.isDark = colours.matches && !paper.matches;
  }
}
