// Draws a scene and its rays on a canvas. What a drawing holds, as JSON (every point is [x, y, z]):
//   about     what it shows, one line
//   spheres   [{name, centre, radius, colour}]           planes [{name, point, normal, colour}]
//   lights    [{name, centre, radius}]                   lens   {halfWidth}    focalPlane  z
//   rays      [{k, a, b, t, p, l}]: kind, from, to, its words, the index of the ray before it, the light
//   normals   [{at, smooth, given, expected}]             outlines   [[point, point, ...]]: lines on a surface
//   words     lines that tell the whole
const kRayKinds = {
  camera: { name: "camera rays", light: "#0064a8", dark: "#6cc0f5", dash: [] },
  reflected: { name: "reflected rays", light: "#9a3f7c", dark: "#e39bc6", dash: [9, 3] },
  arrives: { name: "shadow rays that arrive", light: "#a36a00", dark: "#f2b134", dash: [] },
  blocked: { name: "shadow rays that are blocked", light: "#b83a00", dark: "#ff7d45", dash: [3, 4] },
  other: { name: "other rays", light: "#666666", dark: "#aaaaaa", dash: [2, 3] },
  expected: { name: "expected", light: "#00735a", dark: "#35c9a0", dash: [7, 3, 2, 3] },
};
const kNormalKinds = {
  smooth: { name: "smooth normals", light: "#666666", dark: "#aaaaaa", dash: [2, 3] },
  expected: { name: "expected normals", light: "#00735a", dark: "#35c9a0", dash: [7, 3] },
  given: { name: "normals given", light: "#0064a8", dark: "#6cc0f5", dash: [] },
};
/// About so many rays are shown while a drawing turns, so that it follows the mouse.
const kMostMoving = 500;
/// More lines than these are drawn one pixel wide, which takes a seventh of the time of 1.3.
const kMany = 100;

class RayDrawing {
  constructor(canvas) {
    this.canvas = canvas;
    this.pen = canvas.getContext("2d");
    this.orbit = new Orbit();
    this.hidden = new Set();
    this.chosen = -1;
    this.isDark = false;
    this.data = { spheres: [], planes: [], lights: [], rays: [] };
  }

  /// Takes another drawing; `draw` then shows it.
  show(data, keepsView) {
    this.data = data;
    this.chosen = -1;
    this.orbit.isOfNormals = data.rays.length === 0 && (data.normals || []).length > 0;
    this.orbit.course = courseOf(this.orbit.isOfNormals ? data.normals.map(({ smooth, given }) => smooth || given)
      : data.rays.map(({ a, b }) => minus(b, a)));
    this.frame(keepsView);
  }

  /// Looks at all of it, from where the first view does unless it keeps the view.
  frame(keepsView = false) {
    const points = pointsOf(this.data);
    this.orbit.frame(points);
    if (!keepsView) this.orbit.home();
    this.orbit.fill(points);
  }

  resize(width, height, dots) {
    const [across, down] = [Math.round(width * dots), Math.round(height * dots)];
    if (this.canvas.width === across && this.canvas.height === down) return;
    Object.assign(this.canvas, { width: across, height: down });
    this.pen.setTransform(dots, 0, 0, dots, 0, 0);
    const isFirst = !this.orbit.width;
    this.orbit.resize(width, height);
    if (isFirst) this.frame();
  }

  colour(kind) { return this.isDark ? kind.dark : kind.light; }

  draw(isMoving = false) {
    const { width, height } = this.orbit;
    if (!width) return;
    this.pen.fillStyle = this.isDark ? "#14171b" : "#fbfaf7";
    this.pen.fillRect(0, 0, width, height);
    for (const plane of this.data.planes) this.drawPlane(plane);
    if (this.data.focalPlane) this.drawFocalPlane();
    const far = (centre) => this.orbit.seen(centre)[2];
    for (const sphere of [...this.data.spheres].sort((a, b) => far(b.centre) - far(a.centre)))
      this.drawSphere(sphere);
    for (const light of this.data.lights) this.drawLight(light);
    this.drawOutlines();
    this.drawRays(isMoving);
    this.drawNormals();
    if (this.data.lens) this.drawLens();
    this.drawChosen();
  }

  /// Strokes all these lines, [[from, to], ...]: plain ones at once, dashed ones one by one, because
  /// many dashes in one path take twenty times as long.
  strokeAll(lines, colour, width, dash = [], alpha = 1) {
    this.pen.globalAlpha = alpha;
    this.pen.setLineDash(dash);
    this.pen.strokeStyle = colour;
    this.pen.lineWidth = width;
    this.pen.beginPath();
    for (const [from, to] of lines) {
      const ends = this.orbit.segment(from, to);
      if (!ends) continue;
      if (dash.length) this.pen.beginPath();
      this.pen.moveTo(ends[0], ends[1]);
      this.pen.lineTo(ends[2], ends[3]);
      if (dash.length) this.pen.stroke();
    }
    if (!dash.length) this.pen.stroke();
    this.pen.setLineDash([]);
    this.pen.globalAlpha = 1;
  }

  label(text, point, colour) {
    const at = this.orbit.project(point);
    if (!at) return;
    this.pen.font = "12px system-ui, sans-serif";
    this.pen.lineWidth = 3;
    this.pen.strokeStyle = this.isDark ? "#14171b" : "#fbfaf7";
    // The name of a point in sight is not cut off at the right edge.
    const most = at[0] < this.orbit.width ? this.orbit.width - this.pen.measureText(text).width - 3 : Infinity;
    const x = Math.min(at[0] + 5, most);
    this.pen.strokeText(text, x, at[1] - 5);
    this.pen.fillStyle = colour;
    this.pen.fillText(text, x, at[1] - 5);
  }

  ink() { return this.isDark ? "#a5afba" : "#57616b"; }

  /// A grid of a plane about the point of it that is nearest to what the drawing looks at.
  drawPlane({ point, normal, name }) {
    const axis = unit(normal);
    const [right, up] = besides(axis);
    const target = this.orbit.target;
    const foot = plus(target, axis, -dot(minus(target, point), axis));
    const reach = 4 * Math.max(1, 2 ** Math.round(Math.log2(this.orbit.size / 4)));
    const lines = [];
    for (let i = -4; i <= 4; ++i) {
      const at = i / 4 * reach;
      lines.push([plus(plus(foot, right, at), up, -reach), plus(plus(foot, right, at), up, reach)],
        [plus(plus(foot, up, at), right, -reach), plus(plus(foot, up, at), right, reach)]);
    }
    this.strokeAll(lines, this.ink(), 1, [], 0.35);
    this.label(name, plus(plus(foot, right, reach), up, -reach), this.ink());
  }

  dot(centre, colour) {
    const at = this.orbit.project(centre);
    if (!at) return;
    this.pen.beginPath();
    this.pen.arc(at[0], at[1], 1.5, 0, 2 * Math.PI);
    this.pen.fillStyle = colour;
    this.pen.fill();
  }

  /// A ball: its face in one or more colours, [colour, alpha], and its outline.
  ball(centre, radius, faces, ink) {
    const outline = outlineOf(this.orbit.eye, centre, radius);
    if (!outline) return;
    const lines = circleAt(outline.centre, outline.radius, outline.axis, 90);
    const corners = lines.map(([from]) => this.orbit.project(from));
    if (corners.every(Boolean)) {
      this.pen.beginPath();
      for (const corner of corners) this.pen.lineTo(...corner);
      for (const [colour, alpha] of faces) {
        this.pen.globalAlpha = alpha;
        this.pen.fillStyle = colour;
        this.pen.fill();
      }
      this.pen.globalAlpha = 1;
    }
    this.strokeAll(lines, ink, 1.5);
  }

  drawSphere({ centre, radius, colour, name }) {
    this.ball(centre, radius, [[this.isDark ? "#2d343d" : "#dfe3e8", 0.75], [colour, 0.3]], this.ink());
    this.strokeAll([...circleAt(centre, radius, [0, 1, 0]), ...circleAt(centre, radius, [1, 0, 0]),
      ...circleAt(centre, radius, [0, 0, 1])], this.ink(), 1, [], 0.35);
    this.label(name, plus(centre, this.orbit.up, radius), this.ink());
  }

  drawLight({ centre, radius, name }) {
    this.ball(centre, radius, [["#ffd84d", 0.55]], this.colour(kRayKinds.arrives));
    this.dot(centre, this.colour(kRayKinds.arrives));
    this.label(name, plus(centre, this.orbit.up, radius), this.colour(kRayKinds.arrives));
  }

  square(z, halfWidth, halfHeight) {
    const corners = squareAt(z, halfWidth, halfHeight);
    return corners.map((corner, i) => [corner, corners[(i + 1) % 4]]);
  }

  drawFocalPlane() {
    const z = this.data.focalPlane;
    const half = z * Math.tan(Math.PI / 8);
    this.strokeAll(this.square(z, half, 0.75 * half), this.colour(kRayKinds.expected), 1.5, [6, 4]);
    this.label("plane in focus", [half, 0.75 * half, z], this.colour(kRayKinds.expected));
  }

  drawLens() {
    const colour = this.colour(kRayKinds.expected);
    this.strokeAll(this.square(0, this.data.lens.halfWidth), colour, 2);
    this.dot([0, 0, 0], colour);
    this.label(this.data.lens.halfWidth > 0 ? "lens" : "eye", [this.data.lens.halfWidth, this.data.lens.halfWidth, 0], colour);
  }

  drawRays(isMoving) {
    const step = isMoving ? Math.ceil(this.data.rays.length / kMostMoving) : 1;
    for (const [name, kind] of Object.entries(kRayKinds)) {
      if (this.hidden.has(name)) continue;
      const lines = this.data.rays.filter((ray) => ray.k === name).filter((_, i) => i % step === 0)
        .map((ray) => [ray.a, ray.b]);
      // Dashes cost more than all the rest: a drawing that turns does without where there are many.
      const dash = isMoving && lines.length > kMany ? [] : kind.dash;
      // Many rays are pale, so that the others are seen through them.
      const alpha = Math.min(0.9, Math.max(0.1, 40 / lines.length));
      if (lines.length) this.strokeAll(lines, this.colour(kind), lines.length > kMany ? 1 : 1.3, dash, alpha);
    }
  }

  arrow(at, direction, kind) {
    const length = this.orbit.isOfNormals ? 0.27 * this.orbit.size : 0.09 * this.orbit.size + 0.05;
    const tip = plus(at, unit(direction), length);
    const ends = this.orbit.segment(at, tip);
    this.strokeAll([[at, tip]], this.colour(kind), 2, kind.dash);
    if (!ends) return;
    const angle = Math.atan2(ends[3] - ends[1], ends[2] - ends[0]);
    this.pen.beginPath();
    for (const side of [-0.45, 0.45]) {
      this.pen.moveTo(ends[2], ends[3]);
      this.pen.lineTo(ends[2] - 8 * Math.cos(angle + side), ends[3] - 8 * Math.sin(angle + side));
    }
    this.pen.stroke();
  }

  drawOutlines() {
    for (const line of this.data.outlines || [])
      this.strokeAll(line.slice(1).map((point, i) => [line[i], point]), this.ink(), 2);
  }

  drawNormals() {
    for (const normal of this.data.normals || [])
      for (const [name, kind] of Object.entries(kNormalKinds))
        if (normal[name] && !this.hidden.has(name + "Normal")) this.arrow(normal.at, normal[name], kind);
  }

  drawChosen() {
    const ray = this.data.rays[this.chosen];
    if (!ray) return;
    this.strokeAll([[ray.a, ray.b]], this.isDark ? "#ffffff" : "#000000", 6);
    this.strokeAll([[ray.a, ray.b]], this.colour(kRayKinds[ray.k]), 3);
    this.dot(ray.b, this.isDark ? "#ffffff" : "#000000");
  }
}
