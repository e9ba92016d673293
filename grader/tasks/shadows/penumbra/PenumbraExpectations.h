#ifndef TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRAEXPECTATIONS_H
#define TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRAEXPECTATIONS_H

#include <grader/tasks/shadows/penumbra/PenumbraShares.h>
#include <grader/tasks/support/Shelf.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <tuple>

namespace ticker::tasks {

/// The shares that are expected at the places of one question. Each is computed when it is first
/// asked for, and kept: references stay valid as long as this object. Several threads may use it.
class PenumbraExpectations {
public:
    explicit PenumbraExpectations(PenumbraQuestion asked);
    /// @param seed  Of the question.
    explicit PenumbraExpectations(std::uint64_t seed)
        : PenumbraExpectations(drawPenumbraQuestion(seed)) {}

    [[nodiscard]] const PenumbraQuestion& asked() const { return asked_; }

    /// @param size  Radius of the light in units of lightSize.
    [[nodiscard]] const ExpectedShares& at(const PenumbraQuestion::Place& place, AimShape shape,
                                           double size = 1.0);

private:
    using Key = std::tuple<std::size_t, AimShape::Radius, AimShape::Poles, double>;

    const PenumbraQuestion asked_;
    const Surfaces surfaces_;
    std::mutex mutex_;
    std::map<Key, ExpectedShares> shares_;
};

/// By the seed of the question.
using PenumbraShelf = Shelf<std::uint64_t, PenumbraExpectations>;

}  // namespace ticker::tasks

#endif
