#ifndef RAYTRACER_APP_PROGRESSTEXT_H
#define RAYTRACER_APP_PROGRESSTEXT_H

#include <string>

namespace raytracer {

/// The text of a bar: `[#####-----]  50 %, 12 s left`; without the time where nothing is done yet.
/// @param done, all  Rows of a picture, or steps of a build.
/// @param seconds    Time since the start.
[[nodiscard]] std::string progressText(int done, int all, double seconds);

}  // namespace raytracer

#endif
