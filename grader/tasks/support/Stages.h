#ifndef TICKER_TASKS_SUPPORT_STAGES_H
#define TICKER_TASKS_SUPPORT_STAGES_H

#include <grader/probe/Examinee.h>
#include <grader/result/FindingText.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ticker::tasks {

/// The verdict of one round of questions with random answers.
struct Stage {
    std::optional<Finding> failure;             ///< held against the submission if it comes twice
    std::optional<Finding> doubt;               ///< a warning: a person has to look, and why
    std::optional<double> apertureFactor = {};  ///< of a picture: the accepted one that fits best
};

/// The seed of a stage's questions.
[[nodiscard]] std::uint64_t seedOf(std::uint64_t seed, std::uint64_t stage);

/// A warning: a person has to look.
[[nodiscard]] Stage doubtful(const FindingText& text, std::string why);

/// An answer that does not come here, though it came before, is a doubt and no failure.
[[nodiscard]] Stage unanswered(const probe::Run& run, std::string_view function);

/// @return  Null where the question has no answer in full.
template <class Answer>
const Answer* answeredBy(const probe::Run& run, std::size_t question = 0) {
    if (run.answers.size() <= question) return nullptr;
    const auto* answer = std::get_if<Answer>(&run.answers[question]);
    return answer != nullptr && answer->state == probe::AnswerState::answered ? answer : nullptr;
}

/// Asks once, and again on other questions where that failed: a failure that does not come again is
/// none, but a person should look.
/// @param judge  Judges the stage of a number, 1 or 2.
/// @return  Whether a person has to look; the reason is added to `findings`, or the failure.
[[nodiscard]] bool keepRepeated(std::vector<Finding>& findings,
                                const std::function<Stage(std::uint64_t)>& judge);

}  // namespace ticker::tasks

#endif
