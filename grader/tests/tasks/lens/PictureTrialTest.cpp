#include <grader/tasks/lens/checks/Expectations.h>
#include <grader/tasks/lens/checks/PictureMistakes.h>
#include <grader/tasks/lens/checks/PictureTrial.h>
#include <grader/tasks/lens/questions/PictureQuestions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ticker::tasks {
namespace {

constexpr std::uint64_t kTrialSeed = 5;

probe::RenderQuestion trialQuestion() {
    probe::RenderQuestion asked = drawPictureQuestion(kTrialSeed);
    asked.settings.width = 8;
    asked.settings.height = 6;
    return asked;
}

/// The expected picture, changed by this share of a mistake. Neighbouring repetitions lie this many
/// standard deviations above and below.
SeenPictures changed(Expectations& expectations, std::size_t mistake, double share,
                     double deviations) {
    const ExpectedPicture& expected = expectations.under({});
    const Plane& mistaken = expectations.underMistake({}, mistake, Exactness::judging);
    probe::RenderAnswer answer;
    answer.state = probe::AnswerState::answered;
    answer.width = expectations.asked().settings.width;
    answer.height = expectations.asked().settings.height;
    for (int i = 0; i < expectations.asked().repetitions; ++i) {
        const double side = i % 2 == 0 ? deviations : -deviations;
        auto& image = answer.images.emplace_back();
        for (std::size_t pixel = 0; pixel < expected.mean.size(); ++pixel)
            image.emplace_back(expected.mean[pixel] +
                               share * (mistaken[pixel] - expected.mean[pixel]) +
                               side * std::sqrt(expected.variance[pixel]));
    }
    return readPictures(answer);
}

TEST(TryToFit, FitsExactlyWhereTheWholeTrialFindsNothingAndNoneOfThoseIsRuledOut) {
    Expectations expectations{trialQuestion(), kTrialSeed};
    const std::size_t mistakes = pictureMistakes({}).size();
    int fitting = 0;
    int roughlyOut = 0;
    for (std::size_t mistake = 0; mistake < mistakes; ++mistake)
        for (const double share : {0.0, 0.04, 0.3, 1.0})
            for (const double deviations : {0.9, 1.7}) {
                const SeenPictures seen = changed(expectations, mistake, share, deviations);
                const Candidate candidate = candidateOf(expectations, seen, {});
                const PictureVerdict whole = tryReading(expectations, seen, candidate).verdict;
                const bool fits = !whole.finding && !whole.ambiguous;
                EXPECT_EQ(tryToFit(expectations, seen, candidate).has_value(), fits)
                    << mistake << ' ' << share << ' ' << deviations;
                const bool ruledOut = isRuledOut(expectations, seen, {});
                EXPECT_FALSE(fits && ruledOut) << mistake << ' ' << share << ' ' << deviations;
                fitting += fits ? 1 : 0;
                roughlyOut += ruledOut ? 1 : 0;
            }
    EXPECT_GE(fitting, 5);
    EXPECT_GE(roughlyOut, 5);
}

}  // namespace
}  // namespace ticker::tasks
