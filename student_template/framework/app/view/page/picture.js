// The picture as its pieces come, and another one over it.
class Picture {
  constructor(canvas, other) {
    this.canvas = canvas;
    this.other = other;
    this.pen = canvas.getContext("2d");
    this.kept = { before: null, pinhole: null };
    this.number = 0;
    this.build = -1;
    this.area = 0;
  }

  /// A new picture begins; the last one stays until its pieces are painted over.
  begin({ number, build, width, height }, isNewScene) {
    if (isNewScene) {
      this.kept.before = null;
      this.compare("");
    } else if (this.build >= 0 && build !== this.build) this.kept.before = this.copy(this.canvas);
    this.number = number;
    this.build = build;
    this.area = 0;
    this.kept.pinhole = null;
    if (this.canvas.width === width && this.canvas.height === height) return;
    const last = this.copy(this.canvas);
    for (const canvas of [this.canvas, this.other]) Object.assign(canvas, { width, height });
    this.pen.drawImage(last, 0, 0, width, height);
  }

  add({ at, rgb }) {
    const small = this.imageOf(atob(rgb), at.across, at.down, (letters, i) => letters.charCodeAt(i));
    this.pen.imageSmoothingEnabled = false;
    this.pen.drawImage(small, at.x, at.y, at.width, at.height);
    if (!at.stage) this.area += at.width * at.height;
  }

  share() { return this.area / (this.canvas.width * this.canvas.height); }

  /// byteAt: how a byte is read from `rgb`.
  imageOf(rgb, width, height, byteAt = (bytes, i) => bytes[i]) {
    const image = new ImageData(width, height);
    const { data } = image;
    for (let from = 0, to = 0; from < rgb.length; from += 3, to += 4) {
      data[to] = byteAt(rgb, from);
      data[to + 1] = byteAt(rgb, from + 1);
      data[to + 2] = byteAt(rgb, from + 2);
      data[to + 3] = 255;
    }
    const canvas = document.createElement("canvas");
    Object.assign(canvas, { width, height });
    canvas.getContext("2d").putImageData(image, 0, 0);
    return canvas;
  }

  copy(canvas) {
    const copy = document.createElement("canvas");
    Object.assign(copy, { width: canvas.width, height: canvas.height });
    copy.getContext("2d").drawImage(canvas, 0, 0);
    return copy;
  }

  /// Lays one of the kept pictures over this one; "": none.
  compare(name) {
    const kept = this.kept[name];
    this.other.hidden = !kept;
    if (kept) this.other.getContext("2d").drawImage(kept, 0, 0, this.other.width, this.other.height);
  }
}
