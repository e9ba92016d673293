#ifndef TICKER_TASKS_DISTRIBUTED_PENUMBRAQUESTION_H
#define TICKER_TASKS_DISTRIBUTED_PENUMBRAQUESTION_H

#include <grader/probe/Question.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::tasks {

/// For code whose shadow rays cannot be seen: points that see a part of the light, each asked many
/// times without a log. Every call moves the point by less than anything can depend on, but for a
/// generator that is seeded by the place. A sphere stands before the light, and a smaller one in
/// it.
struct PenumbraQuestion {
    struct Place {
        enum class Kind {
            penumbra,  ///< sees a part of the light, at most three quarters of its radius from half
            beyondRim,  ///< sees nothing of it, but a light 8 % larger would be seen
            withinRim,  ///< sees its outermost part alone, nothing of a light four fifths as large
            atRim       ///< likewise, nothing of a light that is smaller by a twentieth
        };
        Kind kind = Kind::penumbra;
        bool fromLens = false;  ///< seen from a point of the lens, as camera rays do
        std::size_t first = 0;  ///< index of its first call in question.points
        std::size_t calls = 0;
    };
    probe::IlluminateQuestion question;
    std::vector<Place> places;
};
[[nodiscard]] PenumbraQuestion drawPenumbraQuestion(std::uint64_t seed);

}  // namespace ticker::tasks

#endif
