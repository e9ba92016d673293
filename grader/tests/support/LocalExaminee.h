#ifndef TICKER_TESTS_SUPPORT_LOCALEXAMINEE_H
#define TICKER_TESTS_SUPPORT_LOCALEXAMINEE_H

#include <grader/probe/AnswerMemory.h>
#include <grader/probe/Examinee.h>
#include <grader/probe/Respond.h>
#include <grader/probe/Wire.h>

#include <cstdint>

namespace ticker::tests {

/// Answers with the solution that is linked into the test program (`solution_reference`, say), in
/// the same process, with the same bytes that a sandboxed probe would see. For tests only: a
/// solution that crashes ends the test.
class LocalExaminee final : public probe::Examinee {
public:
    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        const probe::AnswerLayout layout = probe::layoutFor(questions);
        std::vector<std::uint64_t> words((layout.totalBytes + 7) / 8);
        const auto memory = std::as_writable_bytes(std::span{words});
        probe::fillUnanswered(memory, layout);
        probe::respond(probe::decodeQuestions(probe::encodeQuestions(questions)), memory);
        return {probe::readAnswers(questions, memory), {}};
    }
};

}  // namespace ticker::tests

#endif
