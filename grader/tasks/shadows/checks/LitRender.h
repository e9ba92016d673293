#ifndef TICKER_TASKS_DISTRIBUTED_LITRENDER_H
#define TICKER_TASKS_DISTRIBUTED_LITRENDER_H

#include <grader/tasks/shadows/answers/ShadowLog.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace ticker::tasks {

/// A picture of a wall that two lights shine on, with a sphere before each; lights and spheres
/// stand outside of the picture, so that every lens ray meets the wall. The handout's settings, on
/// a tiny frame.
[[nodiscard]] probe::RenderQuestion drawLitQuestion(std::uint64_t seed, int threads);

/// What `illuminate` did while a picture of `drawLitQuestion` was rendered: what a thread cast
/// between the beginning and the end of a point's lighting belongs to that point.
struct LitRender {
    ShadowQuestion asked;            ///< the points that were lit, as if they had been asked for
    probe::IlluminateAnswer answer;  ///< their colours and rays
    std::size_t lensRays = 0;        ///< different rays from outside
    std::size_t looseRays = 0;  ///< rays from the wall to a light outside of any point's lighting
};
[[nodiscard]] LitRender readLitRender(const probe::RenderQuestion& asked,
                                      const probe::RenderAnswer& answer);

/// How the shadows of a render differ from those of single points, in words; empty where they do
/// not, or where too little can be seen. Exact: one accepted reading has to fit every point.
[[nodiscard]] std::optional<std::string> litDifference(const LitRender& lit);

}  // namespace ticker::tasks

#endif
