#ifndef RAYTRACER_APP_JOBS_H
#define RAYTRACER_APP_JOBS_H

#include "Options.h"

#include <raytracer/base/Error.h>

namespace raytracer {

/// Renders the scene to its file, with progress, preview and comparison according to the options.
/// @throws InputError if a file cannot be read or written.
[[nodiscard]] ExitCode renderPicture(const Options& options);

/// Explains on stdout how the pixel `options.trace` gets its colour.
/// @throws InputError if the scene cannot be read.
[[nodiscard]] ExitCode tellOfPixel(const Options& options);

}  // namespace raytracer

#endif
