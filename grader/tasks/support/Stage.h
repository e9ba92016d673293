#ifndef TICKER_TASKS_SUPPORT_STAGE_H
#define TICKER_TASKS_SUPPORT_STAGE_H

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

/// Result of one round of questions with random answers.
struct Stage {
    std::optional<Finding> failure;             ///< counts against the submission if it repeats
    std::optional<Finding> doubt;               ///< a warning with a reason for review
    std::optional<double> apertureFactor = {};  ///< accepted factor that fits the picture best
    bool decided = false;                       ///< the failure needs no repetition
};

/// The seed of a stage's questions.
[[nodiscard]] std::uint64_t seedOf(std::uint64_t seed, std::uint64_t stage);

/// A warning that asks for review.
[[nodiscard]] Stage doubtful(const FindingText& text, std::string why);

/// The result for a missing answer: a doubt and not a failure, because earlier answers came.
[[nodiscard]] Stage unanswered(const probe::Run& run, std::string_view function);

/// @return  Null if the question has no complete answer.
template <class Answer>
const Answer* answeredBy(const probe::Run& run, std::size_t question = 0) {
    if (run.answers.size() <= question) return nullptr;
    const auto* answer = std::get_if<Answer>(&run.answers[question]);
    return answer != nullptr && answer->state == probe::AnswerState::answered ? answer : nullptr;
}

/// Asks once, and again on other questions if that failed and is not decided. A failure that does
/// not repeat is not held against the submission, but asks for review.
/// @param judge  Judges stage 1 or stage 2.
/// @return  Whether the submission needs review. The reason, or the failure, is added to
///          `findings`.
[[nodiscard]] bool keepRepeated(std::vector<Finding>& findings,
                                const std::function<Stage(std::uint64_t)>& judge);

}  // namespace ticker::tasks

#endif
