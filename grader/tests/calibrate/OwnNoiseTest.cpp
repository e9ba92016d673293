#include <grader/lab/calibrate/OwnNoise.h>

#include <gtest/gtest.h>

#include <variant>
#include <vector>

namespace ticker::calibrate {
namespace {

/// Keeps the questions of the last call.
class Listener final : public probe::Examinee {
public:
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        asked = questions;
        return {};
    }
    std::vector<probe::Question> asked;
};

/// The question that a submission with this seed gets.
probe::RenderQuestion heard(const probe::RenderQuestion& question, std::uint64_t seed) {
    Listener listener;
    OwnNoise noisy{listener, seed};
    (void)noisy.ask({question});
    return std::get<probe::RenderQuestion>(listener.asked.at(0));
}

TEST(OwnNoise, ChangesTheSeedOfTheKitsGeneratorAlone) {
    probe::RenderQuestion question;
    question.settings.seed = 7;
    question.settings.width = 24;
    question.repetitions = 3;
    const probe::RenderQuestion own = heard(question, 1);
    EXPECT_NE(own.settings.seed, 7U);
    EXPECT_EQ(own.settings.seed, heard(question, 1).settings.seed);
    EXPECT_NE(own.settings.seed, heard(question, 2).settings.seed);
    EXPECT_EQ(own.settings.width, 24);
    EXPECT_EQ(own.repetitions, 3);
}

}  // namespace
}  // namespace ticker::calibrate
