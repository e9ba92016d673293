#ifndef TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRAQUESTION_H
#define TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRAQUESTION_H

#include <grader/probe/Question.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::tasks {

/// Question for code whose shadow rays are not visible: points in the penumbra, each asked many
/// times without a log. Every call moves the point by a negligible distance, which only matters to
/// a generator that is seeded from the point. A sphere stands in front of the light, with a smaller
/// one inside it.
struct PenumbraQuestion {
    struct Place {
        enum class Kind {
            penumbra,   ///< sees a part of the light; its centre is hidden or visible by at most
                        ///< three quarters of the radius
            beyondRim,  ///< sees nothing of the light, but would see a light that is 8 % larger
            withinRim,  ///< sees its outermost part only, and nothing of a light four fifths as
                        ///< large
            atRim  ///< sees its outermost part only, and nothing of a light that is smaller by a
                   ///< twentieth
        };
        Kind kind = Kind::penumbra;
        bool fromLens = false;  ///< seen from a point of the lens, as by a camera ray
        std::size_t first = 0;  ///< index of its first call in question.points
        std::size_t calls = 0;
    };
    probe::IlluminateQuestion question;
    std::vector<Place> places;
};
[[nodiscard]] PenumbraQuestion drawPenumbraQuestion(std::uint64_t seed);

}  // namespace ticker::tasks

#endif
