#ifndef TICKER_TASKS_LENS_CHECKS_EXPECTATIONS_H
#define TICKER_TASKS_LENS_CHECKS_EXPECTATIONS_H

#include <grader/oracle/Reading.h>
#include <grader/probe/Question.h>
#include <grader/tasks/lens/answers/Pictures.h>
#include <grader/tasks/support/Shelf.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>

namespace ticker::tasks {

/// The oracle's pictures for one question. Each is computed when it is first asked for, and kept:
/// references stay valid as long as this object. Several threads may use it.
class Expectations {
public:
    /// @param seed  Of the oracle's paths.
    Expectations(probe::RenderQuestion asked, std::uint64_t seed);

    [[nodiscard]] const probe::RenderQuestion& asked() const { return asked_; }

    /// @param reading  Of its fields only the aperture and the pixels' spread may differ from the
    ///                 defaults.
    [[nodiscard]] const ExpectedPicture& under(const oracle::Reading& reading,
                                               Exactness exactness = Exactness::judging);
    /// The template of the mistake with this index among `pictureMistakes(accepted)`.
    [[nodiscard]] const Plane& underMistake(const oracle::Reading& accepted, std::size_t index,
                                            Exactness exactness);

private:
    using Key = std::tuple<double, double, Exactness>;  // aperture, spread
    static Key keyOf(const oracle::Reading& reading, Exactness exactness) {
        return {reading.apertureFactor, reading.pixelSpread, exactness};
    }

    const probe::RenderQuestion asked_;
    const std::uint64_t seed_;
    std::mutex mutex_;
    std::map<Key, ExpectedPicture> pictures_;
    std::map<std::pair<Key, std::size_t>, Plane> mistaken_;
};

/// By seed, and by what tells the questions of a seed apart: width and repetitions.
using ExpectationShelf = Shelf<std::tuple<std::uint64_t, int, int>, Expectations>;
/// @param asked  From `drawPictureQuestion` or `drawFinePictureQuestion` with this seed.
[[nodiscard]] inline std::shared_ptr<Expectations> expectationsOf(
    ExpectationShelf& shelf, const probe::RenderQuestion& asked, std::uint64_t seed) {
    return shelf.of({seed, asked.settings.width, asked.repetitions}, asked, seed);
}

}  // namespace ticker::tasks

#endif
