#ifndef RAYTRACER_APP_VIEW_WORKER_H
#define RAYTRACER_APP_VIEW_WORKER_H

#include <string_view>

namespace raytracer::view {

/// The argument that makes tick1star a worker: the process that runs the solution for the viewer,
/// which outlives its crashes and starts another one after a build.
inline constexpr std::string_view kWorkerArgument = "--view-worker";

// A command is one line on stdin: verb, number and arguments, with tabs between them. An answer is
// a line "KIND NUMBER BYTES", then that many bytes.
//   picture  options of tick1star   -> "part" again and again, until another picture is asked
//                                      for: a line of numbers and the stage, then red, green, blue
//   whole    options of tick1star   -> "part", with the whole picture
//   pixel    x, y, options          -> "drawing" (JSON)
//   point    x, y, z, options       -> "drawing"
// Each of them -> "failed" with words where it cannot be done.

/// Answers commands until stdin ends, then ends the process at once.
[[noreturn]] void runWorker();

}  // namespace raytracer::view

#endif
