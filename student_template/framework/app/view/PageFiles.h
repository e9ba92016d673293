#ifndef RAYTRACER_APP_VIEW_PAGEFILES_H
#define RAYTRACER_APP_VIEW_PAGEFILES_H

#include <string>

namespace raytracer::view {

// The files of page/, carried in the program.
[[nodiscard]] std::string viewHtml();
[[nodiscard]] std::string viewCss();
[[nodiscard]] std::string viewJs();

}  // namespace raytracer::view

#endif
