#include <grader/tasks/lens/checks/Expectations.h>
#include <grader/tasks/lens/checks/PictureMistakes.h>

#include <utility>

namespace ticker::tasks {

Expectations::Expectations(probe::RenderQuestion asked, std::uint64_t seed)
    : asked_(std::move(asked)), seed_(seed) {}

const ExpectedPicture& Expectations::under(const oracle::Reading& reading, Exactness exactness) {
    const std::lock_guard lock{mutex_};
    const auto [known, isNew] = pictures_.try_emplace(keyOf(reading, exactness));
    if (isNew) known->second = expectedPicture(asked_, reading, seed_, exactness);
    return known->second;
}

// Templates have a seed of their own, so that their noise is independent of the expected picture's.
const Plane& Expectations::underMistake(const oracle::Reading& accepted, std::size_t index,
                                        Exactness exactness) {
    const std::lock_guard lock{mutex_};
    const auto [known, isNew] = mistaken_.try_emplace({keyOf(accepted, exactness), index});
    if (isNew)
        known->second =
            templateOf(pictureMistakes(accepted).at(index), asked_, seed_ + 1, exactness);
    return known->second;
}

}  // namespace ticker::tasks
