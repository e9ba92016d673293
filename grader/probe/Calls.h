#ifndef TICKER_PROBE_CALLS_H
#define TICKER_PROBE_CALLS_H

#include <raytracer/math/Vector3.h>
#include <raytracer/scene/Scene.h>

#include <span>
#include <string_view>

namespace ticker::probe {

/// A function that a `CallQuestion` calls by its name in the submission's process, to ask code of
/// the student that no other question asks.
struct Call {
    std::string_view name;
    /// @param scene  Of the question.
    /// @param arguments  Of one call, as many as the question says.
    /// @return  Up to three numbers; those that the function does not give are 0.
    raytracer::Vector3 (*function)(const raytracer::Scene& scene,
                                   std::span<const double> arguments);
};

/// The calls of an exercise. Its grader/exercises/NAME/Calls.cpp defines this function and is
/// linked into its kit; an exercise without that file has no calls.
[[nodiscard]] std::span<const Call> calls();

}  // namespace ticker::probe

#endif
