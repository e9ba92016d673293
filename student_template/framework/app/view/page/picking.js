// What lies under a place on the canvas, and what a point sees of a light or the lens.

/// The index of the ray that passes nearest to (x, y), at most `reach` pixels away; -1: none.
function rayAt(drawing, x, y, reach = 6) {
  let best = -1;
  let least = reach * reach;
  drawing.data.rays.forEach((ray, index) => {
    if (drawing.hidden.has(ray.k)) return;
    const ends = drawing.orbit.segment(ray.a, ray.b);
    if (!ends) return;
    const [ax, ay, bx, by] = ends;
    const length = (bx - ax) ** 2 + (by - ay) ** 2 || 1;
    const share = Math.min(1, Math.max(0, ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length));
    const away = (ax + share * (bx - ax) - x) ** 2 + (ay + share * (by - ay) - y) ** 2;
    if (away < least) { least = away; best = index; }
  });
  return best;
}

/// The point of the nearest surface that is seen at (x, y); null where there is none.
function surfaceAt(drawing, x, y) {
  const { eye } = drawing.orbit;
  const direction = drawing.orbit.through(x, y);
  let nearest = Infinity;
  for (const { centre, radius } of drawing.data.spheres) {
    const to = minus(centre, eye);
    const ahead = dot(to, direction);
    const inside = ahead * ahead - dot(to, to) + radius * radius;
    const distance = ahead - Math.sqrt(inside);
    if (inside >= 0 && distance > 0) nearest = Math.min(nearest, distance);
  }
  for (const { point, normal } of drawing.data.planes) {
    const distance = dot(minus(point, eye), normal) / dot(direction, normal);
    if (distance > 0) nearest = Math.min(nearest, distance);
  }
  return nearest < Infinity ? plus(eye, direction, nearest) : null;
}

/// Where the shadow rays of one hit pass the light that they aim at, in the light's plane that faces
/// their start: [{light, points: [{x, y, k}]}].
function lightFaces(data, parent) {
  return data.lights.map((light, index) => {
    const rays = data.rays.filter((ray) => ray.p === parent && ray.l === index);
    const points = rays.map((ray) => {
      const axis = unit(minus(light.centre, ray.a));
      const [right, up] = besides(axis);
      const direction = unit(minus(ray.b, ray.a));
      const along = dot(minus(light.centre, ray.a), axis) / dot(direction, axis);
      const beside = minus(plus(ray.a, direction, along), light.centre);
      return { x: dot(beside, right), y: dot(beside, up), k: ray.k };
    });
    return { light, points };
  }).filter(({ points }) => points.length > 0);
}

/// Draws points about the outline that they are expected to fill.
function drawFace(canvas, { radius, isSquare, points }, isDark) {
  const pen = canvas.getContext("2d");
  const side = canvas.width;
  let furthest = Math.max(radius, 0.02);
  for (const { x, y } of points) furthest = Math.max(furthest, Math.abs(x), Math.abs(y)); // as in Orbit.frame
  const reach = 1.1 * furthest;
  const at = (x) => side / 2 * (1 + x / reach);
  const colour = (name) => isDark ? kRayKinds[name].dark : kRayKinds[name].light;
  pen.fillStyle = isDark ? "#14171b" : "#fbfaf7";
  pen.fillRect(0, 0, side, side);
  pen.strokeStyle = colour("expected");
  pen.lineWidth = 3;
  pen.beginPath();
  if (isSquare) pen.rect(at(-radius), at(-radius), at(radius) - at(-radius), at(radius) - at(-radius));
  else pen.arc(side / 2, side / 2, Math.max(2, at(radius) - side / 2), 0, 2 * Math.PI);
  pen.stroke();
  for (const { x, y, k } of points) {
    pen.strokeStyle = pen.fillStyle = colour(k);
    pen.beginPath();
    if (k === "blocked") { // a cross, so that shape tells as well as colour
      for (const turn of [1, -1]) {
        pen.moveTo(at(x) - 6, at(-y) - 6 * turn);
        pen.lineTo(at(x) + 6, at(-y) + 6 * turn);
      }
      pen.stroke();
    } else {
      pen.arc(at(x), at(-y), 5, 0, 2 * Math.PI);
      pen.fill();
    }
  }
}
