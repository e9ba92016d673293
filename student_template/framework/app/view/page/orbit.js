// Points, what a first view should show of a drawing, and a camera that turns about a point. World space: x to the
// right, y up, z into the scene.
const plus = (a, b, times = 1) => [a[0] + b[0] * times, a[1] + b[1] * times, a[2] + b[2] * times];
const minus = (a, b) => plus(a, b, -1);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => { const length = Math.hypot(...a) || 1; return a.map((x) => x / length); };

/// Two unit vectors at right angles to a direction and to each other.
function besides(direction) {
  const axis = unit(direction);
  const first = unit(cross(Math.abs(axis[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0], axis));
  return [first, cross(axis, first)];
}

/// The corners of a square, or of another rectangle, at right angles to the z axis.
const squareAt = (z, halfWidth, halfHeight = halfWidth) =>
  [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => [x * halfWidth, y * halfHeight, z]);

/// The points that a first view should have in it: what belongs to the first hits. Reflected rays
/// may end far away.
function pointsOf(data) {
  const points = [];
  const isNear = (ray) => ray.k !== "reflected" && (ray.p < 0 || data.rays[ray.p].k !== "reflected");
  for (const ray of data.rays) if (!ray.m && isNear(ray)) points.push(ray.a, ray.b);
  const around = (centre, radius) => [-radius, radius].flatMap((r) =>
    [[r, 0, 0], [0, r, 0], [0, 0, r]].map((offset) => plus(centre, offset)));
  data.lights.forEach(({ centre, radius }, light) => {
    if (data.rays.some(({ l }) => l === light)) points.push(...around(centre, radius));
  });
  if (data.rays.length && data.lens) points.push(...squareAt(0, data.lens.halfWidth));
  for (const { at, given, expected } of data.rays.length ? [] : data.normals || [])
    points.push(at, plus(at, unit(given || expected), 0.2));
  for (const { centre, radius } of points.length ? [] : data.spheres) points.push(...around(centre, radius));
  return points.length > 1 ? points : [...points, [0, 0, 0], [0, 0, 4]];
}

/// The direction on the whole, unit length; zero for none.
const courseOf = (directions) => unit(directions.reduce((all, one) => plus(all, unit(one)), [0, 0, 0]));

/// The circle in which a sphere's outline lies, as the eye sees it: nearer than the centre, smaller than
/// the radius. Null from inside of the sphere.
function outlineOf(eye, centre, radius) {
  const axis = minus(eye, centre);
  const share = radius ** 2 / dot(axis, axis);
  return share < 1 ? { centre: plus(centre, axis, share), radius: radius * Math.sqrt(1 - share), axis } : null;
}

/// A circle as lines, [[from, to], ...].
function circleAt(centre, radius, axis, sides = 40) {
  const [right, up] = besides(axis);
  const step = 2 * Math.PI / sides;
  const points = Array.from({ length: sides + 1 }, (_, i) =>
    plus(plus(centre, right, radius * Math.cos(i * step)), up, radius * Math.sin(i * step)));
  return points.slice(1).map((point, i) => [points[i], point]);
}

class Orbit {
  constructor() { this.target = [0, 0, 4]; this.course = [0, 0, 0]; this.home(); }

  /// The view that a drawing begins with: from behind the eye, above it and to its right; from the side
  /// of rays that would come straight towards it. `course`: the direction of all rays, unit length; of
  /// normals where there are no rays, which are seen from before the surface.
  home() {
    const kAlong = 0.85; // cosine
    const [x, y, z] = this.course;
    Object.assign(this, this.isOfNormals ? { yaw: Math.atan2(-x, -z) - 0.4, pitch: Math.asin(y) + 0.3 } : { yaw: -0.6, pitch: 0.35 });
    this.zoom = 1;
    this.update();
    if (!this.isOfNormals && Math.abs(dot(this.ahead, this.course)) > kAlong) this.turn(-Math.PI / 2, 0);
  }

  /// Looks at all of these points, from far enough away.
  frame(points) {
    const [low, high] = [[...points[0]], [...points[0]]];
    for (const point of points) // Safari takes no 80,000 arguments of Math.min
      for (let i = 0; i < 3; ++i) {
        low[i] = Math.min(low[i], point[i]);
        high[i] = Math.max(high[i], point[i]);
      }
    this.target = low.map((x, i) => (x + high[i]) / 2);
    this.size = Math.max(0.05, Math.hypot(...minus(high, low)) / 2);
    this.nearness = 1;
    this.update();
  }

  /// Moves so that these points would fill the canvas without zoom. Turns nothing, and keeps the zoom.
  fill(points) {
    const { zoom } = this;
    this.zoom = 1;
    this.update();
    this.fillUnzoomed(points);
    this.zoom = zoom;
    this.update();
  }

  fillUnzoomed(points) {
    const kFilled = 0.84; // of the width or the height
    const kRounds = 5;    // what is near moves more: each round leaves a small part of the last one's error
    for (let round = 0; this.width && round < kRounds; ++round) {
      const [low, high] = [[Infinity, Infinity], [-Infinity, -Infinity]];
      for (const point of points) {
        const at = this.project(point);
        if (!at) return;
        for (const i of [0, 1]) { low[i] = Math.min(low[i], at[i]); high[i] = Math.max(high[i], at[i]); }
      }
      const perPixel = this.distance / this.scale;
      this.target = plus(plus(this.target, this.right, ((low[0] + high[0]) - this.width) / 2 * perPixel),
        this.up, (this.height - (low[1] + high[1])) / 2 * perPixel);
      const filled = Math.max((high[0] - low[0]) / this.width, (high[1] - low[1]) / this.height);
      this.nearness = Math.min(3, this.nearness * kFilled / Math.max(0.1, filled));
      this.update();
    }
  }

  turn(yaw, pitch) {
    this.yaw += yaw;
    this.pitch = Math.min(1.55, Math.max(-1.55, this.pitch + pitch));
    this.update();
  }

  /// Moves half of the way towards looking at a point.
  approach(point) { this.target = plus(this.target, minus(point, this.target), 0.5); }

  zoomBy(factor) { this.zoom = Math.min(60, Math.max(0.3, this.zoom * factor)); this.update(); }

  resize(width, height) { this.width = width; this.height = height; this.update(); }

  update() {
    const [sy, cy, sp, cp] = [Math.sin(this.yaw), Math.cos(this.yaw), Math.sin(this.pitch), Math.cos(this.pitch)];
    this.right = [cy, 0, -sy];
    this.ahead = [sy * cp, -sp, cy * cp];
    this.up = [sy * sp, cp, cy * sp];
    this.distance = 4 * (this.size || 1) / this.zoom / (this.nearness || 1);
    this.scale = 1.45 * Math.min(this.width || 1, (this.height || 1) * 1.3);
    this.eye = plus(this.target, this.ahead, -this.distance);
  }

  /// Where a point stands: to the right, up, and ahead of the eye.
  seen(point) {
    const from = minus(point, this.eye);
    return [dot(from, this.right), dot(from, this.up), dot(from, this.ahead)];
  }

  onCanvas([x, y, z]) {
    return [this.width / 2 + this.scale * x / z, this.height / 2 - this.scale * y / z];
  }

  /// A point's place on the canvas; null for one behind the eye.
  project(point) {
    const seen = this.seen(point);
    return seen[2] > this.near() ? this.onCanvas(seen) : null;
  }

  near() { return 0.02 * this.distance; }

  /// Both ends of a line on the canvas, cut where it passes the eye; null where all of it is behind.
  segment(from, to) {
    const near = this.near();
    let [a, b] = [this.seen(from), this.seen(to)];
    if (a[2] < near && b[2] < near) return null;
    if (a[2] < near) a = plus(a, minus(b, a), (near - a[2]) / (b[2] - a[2]));
    if (b[2] < near) b = plus(b, minus(a, b), (near - b[2]) / (a[2] - b[2]));
    return [...this.onCanvas(a), ...this.onCanvas(b)];
  }

  /// The direction that a place on the canvas looks into.
  through(x, y) {
    const across = (x - this.width / 2) / this.scale;
    const upwards = (this.height / 2 - y) / this.scale;
    return unit(plus(plus(this.ahead, this.right, across), this.up, upwards));
  }
}
