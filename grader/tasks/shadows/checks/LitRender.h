#ifndef TICKER_TASKS_SHADOWS_CHECKS_LITRENDER_H
#define TICKER_TASKS_SHADOWS_CHECKS_LITRENDER_H

#include <grader/tasks/shadows/answers/ShadowLog.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace ticker::tasks {

/// A picture of a wall with two lights and a sphere in front of each. Lights and spheres are
/// outside of the picture, so that every lens ray meets the wall. The handout's settings, on a tiny
/// frame.
[[nodiscard]] probe::RenderQuestion drawLitQuestion(std::uint64_t seed, int threads);

/// What `illuminate` did during a render of `drawLitQuestion`. Rays that a thread cast between the
/// beginning and the end of a point's lighting belong to that point.
struct LitRender {
    ShadowQuestion asked;            ///< the lit points, in the form of a question
    probe::IlluminateAnswer answer;  ///< their colours and rays
    std::size_t lensRays = 0;        ///< distinct rays from outside
    std::size_t looseRays = 0;  ///< rays from the wall to a light that no point's lighting cast
};
[[nodiscard]] LitRender readLitRender(const probe::RenderQuestion& asked,
                                      const probe::RenderAnswer& answer);

/// Words for a difference between the shadows of a render and those of single points; empty if they
/// agree, or if too little is visible. Exact: one accepted reading must fit every point.
/// @param visible  Whether all shadow rays are visible. If not, only loose rays are counted.
[[nodiscard]] std::optional<std::string> litDifference(const LitRender& lit, bool visible = true);

}  // namespace ticker::tasks

#endif
