#include <grader/tasks/shadows/penumbra/PenumbraExpectations.h>

#include <utility>

namespace ticker::tasks {

PenumbraExpectations::PenumbraExpectations(PenumbraQuestion asked)
    : asked_(std::move(asked)), surfaces_(asked_.question.scene) {}

const ExpectedShares& PenumbraExpectations::at(const PenumbraQuestion::Place& place, AimShape shape,
                                               double size) {
    const std::lock_guard lock{mutex_};
    const auto [known, isNew] =
        shares_.try_emplace(Key{place.first, shape.radius, shape.poles, size});
    if (isNew)
        known->second = expectedAt(asked_.question, surfaces_, asked_.question.points[place.first],
                                   shape, size);
    return known->second;
}

}  // namespace ticker::tasks
