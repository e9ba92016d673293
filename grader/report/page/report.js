"use strict";
// Each pair of pictures: side by side or one over the other, blinking, zooming both together.
for (const compare of document.querySelectorAll(".compare")) {
  const slider = compare.querySelector("input[type=range]");
  const over = compare.querySelector("[data-act=over]");
  const blink = compare.querySelector("[data-act=blink]");
  const setOver = (on) => {
    compare.classList.toggle("over", on);
    over.setAttribute("aria-pressed", String(on));
  };
  slider.addEventListener("input", () => {
    setOver(true);
    compare.style.setProperty("--share", slider.value + "%");
  });
  over.addEventListener("click", () => setOver(!compare.classList.contains("over")));
  blink.addEventListener("click", () => {
    setOver(true);
    compare.style.setProperty("--share", "100%");
    const hidden = compare.classList.toggle("blink");
    blink.setAttribute("aria-pressed", String(hidden));
  });
  let zoom = 1;
  const setZoom = (value) => {
    zoom = Math.min(16, Math.max(1, value));
    compare.style.setProperty("--zoom", zoom);
    compare.querySelector("output").textContent = zoom + "×";
  };
  compare.querySelector("[data-act=in]").addEventListener("click", () => setZoom(zoom * 2));
  compare.querySelector("[data-act=out]").addEventListener("click", () => setZoom(zoom / 2));
  for (const frame of compare.querySelectorAll(".frame")) {
    frame.addEventListener("mousemove", (event) => {
      const box = frame.getBoundingClientRect();
      compare.style.setProperty("--at-x", (100 * (event.clientX - box.left)) / box.width + "%");
      compare.style.setProperty("--at-y", (100 * (event.clientY - box.top)) / box.height + "%");
    });
  }
}
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("input[type=text]")) return;
  const act = { b: "blink", o: "over", "+": "in", "-": "out" }[event.key.toLowerCase()];
  if (!act) return;
  const near = (compare) => Math.abs(compare.getBoundingClientRect().top);
  const all = [...document.querySelectorAll(".compare")].sort((a, b) => near(a) - near(b));
  if (all.length) all[0].querySelector(`[data-act=${act}]`).click();
});
