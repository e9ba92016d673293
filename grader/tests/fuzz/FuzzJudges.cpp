// The judges of both options, with a right solution's answers of which some numbers are replaced.
// They must reach a judgement for all answers, and a failed task must have a finding that fails it.
#include "../support/LocalExaminee.h"
#include "Fuzz.h"

#include <grader/tasks/bump/JudgeBump.h>
#include <grader/tasks/lens/JudgeLens.h>
#include <grader/tasks/shadows/JudgeShadows.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

namespace ticker::fuzz {
namespace {

// One replacement: every `stride`th word of a range.
struct Change {
    std::uint16_t place = 0;  ///< share of the memory, out of 65536
    std::uint8_t stride = 0;
    std::uint8_t count = 0;
    std::uint8_t value = 0;
};

std::vector<Change> changesIn(std::string_view input) {
    std::vector<Change> changes;
    const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(input[at]); };
    for (std::size_t at = 0; at + 5 <= input.size() && changes.size() < 16; at += 5)
        changes.push_back({static_cast<std::uint16_t>(byte(at) << 8U | byte(at + 1)), byte(at + 2),
                           byte(at + 3), byte(at + 4)});
    return changes;
}

std::uint64_t changed(std::uint64_t word, std::uint8_t how) {
    using Limits = std::numeric_limits<double>;
    constexpr std::array kNumbers{0.0,
                                  -0.0,
                                  1.0,
                                  -1.0,
                                  1e308,
                                  -1e308,
                                  1e-300,
                                  Limits::denorm_min(),
                                  Limits::infinity(),
                                  -Limits::infinity(),
                                  Limits::quiet_NaN(),
                                  1e9};
    if (how < kNumbers.size()) return std::bit_cast<std::uint64_t>(kNumbers.at(how));
    if (how < 16) return probe::kUnansweredWord;
    if (how < 24) return ~std::uint64_t{0} >> (how - 16U);
    if (how < 32) return std::bit_cast<std::uint64_t>(-std::bit_cast<double>(word));
    return word ^ (std::uint64_t{1} << (how % 64U));
}

class Liar final : public probe::Examinee {
public:
    explicit Liar(std::vector<Change> changes) : changes_(std::move(changes)) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        const probe::AnswerLayout layout = probe::layoutFor(questions);
        std::vector<std::uint64_t> words((layout.totalBytes + 7) / 8);
        const auto memory = std::as_writable_bytes(std::span{words});
        probe::fillUnanswered(memory, layout);
        probe::respond(questions, memory);
        for (const Change& change : changes_)
            apply(change, words);
        return {probe::readAnswers(questions, memory), {}};
    }

private:
    static void apply(const Change& change, std::vector<std::uint64_t>& words) {
        std::size_t at = change.place * words.size() / 65536;
        for (unsigned i = 0; i <= change.count && at < words.size(); ++i) {
            words[at] = changed(words[at], change.value);
            at += std::size_t{1} + change.stride;
        }
    }

    std::vector<Change> changes_;
};

bool isSound(const TaskJudgement& judgement) {
    const bool hasFailure = std::ranges::any_of(
        judgement.findings, [](const Finding& f) { return f.severity == Severity::fail; });
    return judgement.state != TaskState::failed || hasFailure;
}

}  // namespace

bool give(std::string_view input) {
    if (input.empty()) return false;
    Liar liar{changesIn(input.substr(1))};
    const auto seed = static_cast<unsigned char>(input.front());
    if (seed % 2 == 0) {
        const TaskJudgement bump = tasks::judgeBump(liar, seed / 2U % 4U);
        require(isSound(bump), "a failed task has a finding");
        return bump.state == TaskState::passed;
    }
    bool passed = true;
    for (const auto judge : {tasks::judgeShadows, tasks::judgeLens}) {
        const TaskJudgement judgement = judge(liar, seed / 2U % 4U);
        require(isSound(judgement), "a failed task has a finding");
        passed = passed && judgement.state == TaskState::passed;
    }
    return passed;
}

std::vector<std::string> seeds() {
    std::vector<std::string> inputs{std::string(1, '\0'), std::string(1, '\1')};
    const auto add = [&](char option, char value) {
        inputs.push_back(std::string{option} + '\x40' + value + '\x03' + '\x20' + value);
    };
    // 0, 1e308, infinity, NaN; unanswered; a shorter number of ones; the negative; another bit.
    for (const char value : std::array<char, 8>{0, 4, 8, 10, 13, 18, 27, 36})
        add('\0', value);
    // Fewer of option 2: its questions have renders with two threads, which sleep in each visible
    // ray. Beside other tests that takes four times as long.
    for (const char value : std::array<char, 4>{0, 10, 13, 36})
        add('\1', value);
    return inputs;
}

}  // namespace ticker::fuzz
