#ifndef RAYTRACER_APP_JOBS_H
#define RAYTRACER_APP_JOBS_H

#include "Options.h"

#include <raytracer/base/Error.h>

namespace raytracer {

/// Renders the scene to its file, with progress, preview and comparison as the options say.
/// @throws InputError where something cannot be read or written.
[[nodiscard]] ExitCode renderPicture(const Options& options);

/// Tells on stdout what happens at the pixel `options.trace`.
/// @throws InputError where the scene cannot be read.
[[nodiscard]] ExitCode tellOfPixel(const Options& options);

}  // namespace raytracer

#endif
