#ifndef TICKER_TASKS_LENS_CHECKS_PICTUREMISTAKES_H
#define TICKER_TASKS_LENS_CHECKS_PICTUREMISTAKES_H

#include <grader/oracle/Reading.h>
#include <grader/probe/Question.h>
#include <grader/result/FindingText.h>
#include <grader/tasks/lens/answers/Pictures.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ticker::tasks {

/// A mistake in T2.2 that changes pictures in a known way.
struct PictureMistake {
    const FindingText* text;
    const char* seen;  ///< its visible effect
    oracle::Reading reading;
    oracle::Mistake mistake;
    bool withoutBounces = false;
};

/// All known mistakes, each on top of this accepted reading.
[[nodiscard]] std::vector<PictureMistake> pictureMistakes(const oracle::Reading& accepted);

/// The mean under this mistake, as a template.
[[nodiscard]] Plane templateOf(const PictureMistake& mistake, probe::RenderQuestion asked,
                               std::uint64_t seed, Exactness exactness = Exactness::judging);
/// The template of the mistake with this index.
using Templates = std::function<const Plane&(std::size_t)>;

/// |z| of the part of a difference that exceeds a negligible share of the mistake.
[[nodiscard]] double beyondNegligible(const Match& match);

/// Results of the matched filters of all mistakes.
struct Bank {
    const PictureMistake* best = nullptr;  ///< null if none fits
    const PictureMistake* second = nullptr;
    Match bestMatch;
    double bestLeaves = 1.0;  ///< share of the squared difference that it does not explain
    double largest = 0.0;     ///< |z|
    double beyond = 0.0;      ///< largest `beyondNegligible`
    double squares = 0.0;     ///< sum of all z^2
    double spread = 0.0;      ///< largest `Match::spread`
};
/// @param mistakes  Must outlive the result.
[[nodiscard]] Bank tryAll(const std::vector<PictureMistake>& mistakes, const Templates& templates,
                          const SeenPictures& seen, const ExpectedPicture& expected);

}  // namespace ticker::tasks

#endif
