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

/// What `illuminate` did during a render of `drawLitQuestion`; empty if the log was cut. Rays that
/// a thread cast between the beginning and the end of a point's lighting belong to that point.
struct LitRender {
    ShadowQuestion asked;            ///< the lit points, in the form of a question
    probe::IlluminateAnswer answer;  ///< their colours and rays
    std::size_t lensRays = 0;        ///< distinct rays from outside
    std::size_t looseRays = 0;  ///< rays between the wall and a light, cast outside of `illuminate`
    bool severalThreads = false;  ///< more than one thread lit points
    std::size_t interrupted = 0;  ///< points in whose lighting another thread did something
};
[[nodiscard]] LitRender readLitRender(const probe::RenderQuestion& asked,
                                      const probe::RenderAnswer& answer);

/// The shadow rays that the same code shows when it is asked about single points.
struct VisibleRays {
    bool all = true;      ///< if not, only loose rays are counted
    bool cached = false;  ///< those are left out that a shadow cache finds blocked
    /// Rays from a point to a light, if these are all that a render can show; empty: as many as the
    /// settings ask for.
    std::optional<std::size_t> toALight = {};
};

/// Words for a difference between the shadows of a render and those of single points; empty if they
/// agree, or if too little is visible. Exact: one accepted reading must fit every point.
[[nodiscard]] std::optional<std::string> litDifference(const LitRender& lit,
                                                       const VisibleRays& visible = {});

}  // namespace ticker::tasks

#endif
