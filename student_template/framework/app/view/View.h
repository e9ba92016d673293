#ifndef RAYTRACER_APP_VIEW_VIEW_H
#define RAYTRACER_APP_VIEW_VIEW_H

#include "../Options.h"

#include <raytracer/base/Error.h>

namespace raytracer::view {

/// tick1star --view: serves the page until Ctrl-C. Says what to install where this program was
/// built without the library that it needs.
[[nodiscard]] ExitCode run(const Options& options);

}  // namespace raytracer::view

#endif
