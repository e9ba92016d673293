#ifndef RAYTRACER_BASE_UNFINISHED_H
#define RAYTRACER_BASE_UNFINISHED_H

#include <string>
#include <string_view>

namespace raytracer {

/// Records that a task's stub is still in place; the program goes on. Safe to call from several
/// threads.
///
/// @param task  Tag as in the handout: "M1", "T2.1".
/// @param hint  What must be written in its place.
void unfinished(std::string_view task, std::string_view hint);

/// True once `unfinished` has been called for that task in this program.
[[nodiscard]] bool isUnfinished(std::string_view task);

/// "T1 is not done yet: tilt the smooth normal ..."; empty if `unfinished` was not called for that
/// task in this program.
[[nodiscard]] std::string unfinishedRemark(std::string_view task);

}  // namespace raytracer

#endif
