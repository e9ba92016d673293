const viewers = [...document.querySelectorAll(".viewer")].map((section) => new Viewer(section));
drawRays(document);

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const act = { s: "side", o: "over", b: "blink", "+": "in", "=": "in", "-": "out" }[event.key.toLowerCase()];
  const viewer = act && viewerInSight(viewers);
  if (!viewer) return;
  event.preventDefault();
  viewer.act(act);
});

// On paper nothing can be opened.
window.addEventListener("beforeprint", () => {
  for (const details of document.querySelectorAll("details")) details.open = true;
});
