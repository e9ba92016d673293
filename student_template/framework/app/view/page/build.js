// What a save led to: the build, and the public tests. Comes before view.js, whose helpers it needs.
const stopped = ({ after }) => `took more than ${after} and was stopped; build once in a terminal: ./check`;

function verdict(words, isBad) {
  return element("p", { className: `verdict ${isBad ? "bad" : ""}`, textContent: words });
}

/// The first error with its line, and all that the compiler said.
function errorParts({ file, line, message, source, all }) {
  const parts = [];
  if (message) parts.push(element("p", {}, file ? `${file}, line ${line}: ` : "", message));
  if (source) parts.push(element("pre", { textContent: source.trim(), tabIndex: 0 }));
  parts.push(element("details", {}, element("summary", { textContent: "All that the compiler said" }),
    element("pre", { textContent: all, tabIndex: 0 })));
  return parts;
}

function showBuild(build) {
  const words = { building: "Building ...", built: "Built.", stopped: `The build ${stopped(build)}`,
    failed: "It does not compile. The picture is that of the last program." };
  const isBad = ["failed", "stopped"].includes(build.state);
  byId("build").replaceChildren(verdict(words[build.state], isBad), ...(build.state === "failed" ? errorParts(build) : []));
}

function showTests(tests) {
  if (tests.state === "unasked") return byId("tests").replaceChildren(); // the code is not built
  const words = { running: "The public tests run ...", passed: "The public tests:", none: "No public tests: install GoogleTest.",
    failed: `Not yet: ${tests.title}`, unbuilt: "Your code is built, but the public tests are not:",
    stopped: `Your code is built, but the public tests are not: their build ${stopped(tests)}` };
  const parts = [verdict(words[tests.state], ["failed", "unbuilt", "stopped"].includes(tests.state))];
  if (tests.state === "unbuilt") parts.push(...errorParts(tests));
  if (tests.text) parts.push(element("pre", { textContent: tests.text.trimEnd(), tabIndex: 0 }));
  for (const line of (tests.summary || "").split("\n").filter(Boolean)) parts.push(element("p", { textContent: line }));
  byId("tests").replaceChildren(...parts);
}
