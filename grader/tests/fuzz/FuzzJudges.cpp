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

constexpr std::size_t kBytesOfAChange = 5;
constexpr std::size_t kMostChanges = 16;

std::vector<Change> changesIn(std::string_view input) {
    std::vector<Change> changes;
    const auto byte = [&](std::size_t at) { return static_cast<std::uint8_t>(input[at]); };
    for (std::size_t at = 0; at + kBytesOfAChange <= input.size() && changes.size() < kMostChanges;
         at += kBytesOfAChange)
        changes.push_back({static_cast<std::uint16_t>(byte(at) << 8U | byte(at + 1)), byte(at + 2),
                           byte(at + 3), byte(at + 4)});
    return changes;
}

/// The bytes that `changesIn` reads as this change.
std::string bytesOf(const Change& change) {
    const auto byte = [](unsigned any) { return static_cast<char>(any & 255U); };
    return {byte(change.place / 256U), byte(change.place), byte(change.stride), byte(change.count),
            byte(change.value)};
}

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

// What a word becomes depends on the value of the change: the values below `kUnanswered` are places
// in `kNumbers`, and each of these constants is the first value of its kind.
constexpr std::uint8_t kUnanswered = kNumbers.size();
constexpr std::uint8_t kOnes = 16;  ///< zeros, one for each value above this one, and then ones
constexpr std::uint8_t kNegative = 24;
constexpr std::uint8_t kFlippedBit = 32;  ///< bit number value % 64

std::uint64_t changed(std::uint64_t word, std::uint8_t value) {
    if (value < kUnanswered) return std::bit_cast<std::uint64_t>(kNumbers.at(value));
    if (value < kOnes) return probe::kUnansweredWord;
    if (value < kNegative) return ~std::uint64_t{0} >> (value - unsigned{kOnes});
    if (value < kFlippedBit) return std::bit_cast<std::uint64_t>(-std::bit_cast<double>(word));
    return word ^ (std::uint64_t{1} << (value % 64U));
}

/// The value that makes a word this number, which is one of `kNumbers`.
constexpr std::uint8_t valueOf(double number) {
    const auto bits = [](double any) { return std::bit_cast<std::uint64_t>(any); };
    std::uint8_t value = 0;
    while (bits(kNumbers.at(value)) != bits(number))
        ++value;
    return value;
}

class Liar final : public probe::Examinee {
public:
    explicit Liar(std::vector<Change> changes) : changes_(std::move(changes)) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        const probe::AnswerLayout layout = probe::layoutFor(questions);
        std::vector<std::uint64_t> words((layout.totalBytes + 7) / 8);
        const auto memory = std::as_writable_bytes(std::span{words});
        probe::fillUnanswered(memory, layout);
        probe::respond(changes_.empty() ? questions : onOneThread(questions), memory);
        for (const Change& change : changes_)
            apply(change, words);
        return {probe::readAnswers(questions, memory), {}};
    }

private:
    // Two threads take turns at every ray, which takes most of the time and tells nothing here:
    // what they log is changed anyway.
    static std::vector<probe::Question> onOneThread(std::vector<probe::Question> questions) {
        for (probe::Question& question : questions)
            if (auto* render = std::get_if<probe::RenderQuestion>(&question))
                render->settings.threads = 1;
        return questions;
    }

    static void apply(const Change& change, std::vector<std::uint64_t>& words) {
        std::size_t at = change.place * words.size() / 65536;
        for (unsigned i = 0; i <= change.count && at < words.size(); ++i) {
            words[at] = changed(words[at], change.value);
            at += std::size_t{1} + change.stride;
        }
    }

    std::vector<Change> changes_;
};

// The first byte of an input: the lowest bit is the option, the next two are the judges' seed.
constexpr char kOption1 = 0;
constexpr char kOption2 = 1;

/// An input of one change, with seed 0. The value also moves the place, from a quarter of the
/// memory.
std::string inputWith(char option, std::uint8_t value) {
    Change change;
    change.place = static_cast<std::uint16_t>(0x4000U + value);
    change.stride = 3;
    change.count = 32;
    change.value = value;
    return option + bytesOf(change);
}

bool isSound(const TaskJudgement& judgement) {
    const bool hasFailure = std::ranges::any_of(
        judgement.findings, [](const Finding& f) { return f.severity == Severity::fail; });
    return judgement.state != TaskState::failed || hasFailure;
}

}  // namespace

bool give(std::string_view input) {
    if (input.empty()) return false;
    Liar liar{changesIn(input.substr(1))};
    const auto first = static_cast<unsigned char>(input.front());
    const std::uint64_t seed = first / 2U % 4U;
    if (first % 2 == kOption1) {
        const TaskJudgement bump = tasks::judgeBump(liar, seed);
        require(isSound(bump), "a failed task has a finding");
        return bump.state == TaskState::passed;
    }
    bool passed = true;
    for (const auto judge : {tasks::judgeShadows, tasks::judgeLens}) {
        const TaskJudgement judgement = judge(liar, seed);
        require(isSound(judgement), "a failed task has a finding");
        passed = passed && judgement.state == TaskState::passed;
    }
    return passed;
}

std::vector<std::string> seeds() {
    // One value of each kind.
    constexpr std::uint8_t kSomeUnanswered = kUnanswered + 1;
    constexpr std::uint8_t kSomeOnes = kOnes + 2;
    constexpr std::uint8_t kSomeNegative = kNegative + 3;
    constexpr std::uint8_t kSomeFlippedBit = kFlippedBit + 4;

    std::vector<std::string> inputs{std::string(1, kOption1), std::string(1, kOption2)};
    for (const std::uint8_t value :
         {valueOf(0.0), valueOf(1e308), valueOf(Limits::infinity()), valueOf(Limits::quiet_NaN()),
          kSomeUnanswered, kSomeOnes, kSomeNegative, kSomeFlippedBit})
        inputs.push_back(inputWith(kOption1, value));
    // Fewer of option 2, whose two tasks take longer.
    for (const std::uint8_t value :
         {valueOf(0.0), valueOf(Limits::quiet_NaN()), kSomeUnanswered, kSomeFlippedBit})
        inputs.push_back(inputWith(kOption2, value));
    return inputs;
}

}  // namespace ticker::fuzz
