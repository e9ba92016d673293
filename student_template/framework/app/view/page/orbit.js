// Points, and a camera that turns about a point. World space: x to the right, y up, z into the scene.
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
    this.update();
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
    this.distance = 4 * (this.size || 1) / this.zoom;
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

  /// How many pixels a length has at a point.
  pixels(point, length) { return this.scale * length / Math.max(this.near(), this.seen(point)[2]); }

  /// The direction that a place on the canvas looks into.
  through(x, y) {
    const across = (x - this.width / 2) / this.scale;
    const upwards = (this.height / 2 - y) / this.scale;
    return unit(plus(plus(this.ahead, this.right, across), this.up, upwards));
  }
}
