/// Turns the rays that a part of a page carries into drawings that can be turned.
function drawRays(root) {
  for (const figure of root.querySelectorAll(".ray-figure")) {
    const box = document.createElement("div");
    figure.prepend(box);
    new RayView(box).show(JSON.parse(figure.querySelector("script").textContent));
  }
}
