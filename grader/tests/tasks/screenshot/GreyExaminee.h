#ifndef TICKER_TESTS_SCREENSHOT_GREYEXAMINEE_H
#define TICKER_TESTS_SCREENSHOT_GREYEXAMINEE_H

#include <grader/probe/Examinee.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

namespace ticker::tasks::screenshot {

/// A pseudo-random number between 0 and 1 from three numbers.
inline double noiseOf(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
    std::uint64_t mixed = a * 0x9E3779B97F4A7C15U + b * 0xD1342543DE82EF95U + c + 1;
    for (int i = 0; i < 3; ++i)
        mixed = (mixed ^ (mixed >> 31U)) * 0xBF58476D1CE4E5B9U;
    return static_cast<double>(mixed >> 11U) * 0x1p-53;
}

/// Everything on which a pixel of a render may depend.
struct GreyPixel {
    const raytracer::RenderSettings& settings;
    std::size_t run;
    std::size_t question;  ///< within the run
    int x;                 ///< column and row in the image of the region
    int y;

    /// Number of the pixel in the full frame.
    [[nodiscard]] std::uint64_t place() const {
        return static_cast<std::uint64_t>((settings.region.y + y) * settings.width +
                                          settings.region.x + x);
    }
};

struct GreyCode {
    std::function<double(const GreyPixel&)> grey;
    bool knowsParts = true;  ///< renders regions, not only whole frames
    std::size_t answeredRuns = std::numeric_limits<std::size_t>::max();  ///< then no answers
};

/// Renders grey pixels.
class GreyExaminee final : public probe::Examinee {
public:
    explicit GreyExaminee(GreyCode code) : code_(std::move(code)) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        probe::Run run;
        for (std::size_t i = 0; i < questions.size(); ++i)
            run.answers.emplace_back(
                render(std::get<probe::RenderQuestion>(questions[i]).settings, i));
        ++runs_;
        return run;
    }
    [[nodiscard]] std::size_t runs() const { return runs_; }

private:
    [[nodiscard]] probe::RenderAnswer render(const raytracer::RenderSettings& settings,
                                             std::size_t question) const {
        probe::RenderAnswer answer;
        answer.width = settings.imageWidth();
        answer.height = settings.imageHeight();
        answer.wrongSize = !code_.knowsParts && !settings.region.isWholeFrame();
        answer.images.resize(1);
        if (runs_ >= code_.answeredRuns) return answer;
        answer.state = probe::AnswerState::answered;
        for (int y = 0; y < answer.height; ++y)
            for (int x = 0; x < answer.width; ++x)
                answer.images[0].emplace_back(code_.grey({settings, runs_, question, x, y}));
        return answer;
    }

    GreyCode code_;
    std::size_t runs_ = 0;
};

/// Answers nothing; its process ends in this way.
class EndingExaminee final : public probe::Examinee {
public:
    explicit EndingExaminee(probe::ProcessEnd end) : end_(std::move(end)) {}
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        return {std::vector<probe::Answer>(questions.size(), probe::RenderAnswer{}), end_};
    }

private:
    probe::ProcessEnd end_;
};

}  // namespace ticker::tasks::screenshot

#endif
