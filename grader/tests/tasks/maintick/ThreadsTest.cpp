#include <grader/tasks/maintick/Exact.h>
#include <grader/tasks/maintick/LightFindings.h>
#include <grader/tasks/maintick/Threads.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

enum class Spoilt { nothing, missing, tooFew, wrongSize, threw };

/// Renders grey pictures; those with two threads of the given scenes have other pixels.
class GreyPictures final : public probe::Examinee {
public:
    explicit GreyPictures(std::vector<int> scenes, int pixels = 1, Spoilt spoilt = Spoilt::nothing)
        : scenes_(std::move(scenes)), pixels_(pixels), spoilt_(spoilt) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run;
        for (std::size_t i = 0; i < questions.size(); ++i) {
            const auto& asked = std::get<probe::RenderQuestion>(questions[i]);
            probe::RenderAnswer answer;
            answer.state = probe::AnswerState::answered;
            answer.images.assign(static_cast<std::size_t>(asked.repetitions),
                                 std::vector<ColourRGB>(16 * 12, ColourRGB{0.5}));
            const auto scene = static_cast<int>(i / 2);
            if (asked.settings.threads == 2 && std::ranges::count(scenes_, scene) > 0)
                for (int k = 0; k < pixels_; ++k)
                    answer.images.back().at(static_cast<std::size_t>(k)).g = 0.6;
            if (i + 1 == questions.size()) spoil(answer);
            run.answers.emplace_back(answer);
        }
        if (spoilt_ == Spoilt::missing) run.answers.pop_back();
        return run;
    }

private:
    void spoil(probe::RenderAnswer& answer) const {
        if (spoilt_ == Spoilt::tooFew) answer.images.erase(answer.images.begin());
        if (spoilt_ == Spoilt::wrongSize) answer.wrongSize = true;
        if (spoilt_ == Spoilt::threw) answer.state = probe::AnswerState::threw;
    }

    std::vector<int> scenes_;
    int pixels_;
    Spoilt spoilt_;
};

std::string told(GreyPictures&& examinee, Shows shows) {
    const auto finding = checkThreads(examinee, 1, shows, kPhongThreadsMixed);
    return finding ? finding->message.substr(finding->message.rfind(": ")) : "";
}

TEST(CheckThreads, CountsThePixelsThatDifferInTheLastSceneAlone) {
    EXPECT_EQ(told(GreyPictures{{}}, Shows::floor), "");
    EXPECT_EQ(told(GreyPictures{{0}, 5}, Shows::floor), ": 5 pixels differ.");
    EXPECT_EQ(told(GreyPictures{{1}, 3}, Shows::shadows), ": 3 pixels differ.");
    EXPECT_EQ(told(GreyPictures{{2}, 1}, Shows::mirrors), ": 1 pixels differ.");
}

TEST(CheckThreads, LeavesToTheTaskBeforeWhatDiffersThereAsWell) {
    EXPECT_EQ(told(GreyPictures{{0, 1}}, Shows::shadows), "");
    EXPECT_EQ(told(GreyPictures{{0, 2}}, Shows::mirrors), "");
    EXPECT_EQ(told(GreyPictures{{1, 2}}, Shows::mirrors), "");
}

TEST(CheckThreads, SaysNothingWhereAPictureIsMissing) {
    for (const Spoilt spoilt : {Spoilt::missing, Spoilt::tooFew, Spoilt::wrongSize, Spoilt::threw})
        EXPECT_EQ(told(GreyPictures{{0}, 2, spoilt}, Shows::floor), "") << static_cast<int>(spoilt);
}

}  // namespace
}  // namespace ticker::tasks::maintick
