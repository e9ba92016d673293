// The probe of a program that carries many edits of a submission. Each round sets the switches of
// some of them and answers all questions, into a memory of its own. Like the probe's main program,
// it opens no file and prints nothing.
#include <grader/probe/AnswerMemory.h>
#include <grader/probe/Respond.h>
#include <grader/probe/Wire.h>
#include <grader/repair/probe/Switches.h>

#include <raytracer/base/Error.h>

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <vector>

// What the program of grader/repair/candidates/Schema.cpp declares.
extern "C" {
unsigned char ticker_edit[ticker::repair::kMostEdits];
void ticker_step();
}

namespace {

// Most steps of all loops in one round, so that a loop that an edit makes endless ends: three times
// the steps without edits, and some more. Before these are measured the limit is far above the
// steps of a right submission.
constexpr long kTimesAsOften = 3;
constexpr long kSomeMore = 10'000;
std::atomic<long> mostSteps{2'000'000};  // NOLINT: shared with the code that is asked
std::atomic<long> steps{0};              // NOLINT: as well

std::span<std::byte> mapped(int descriptor, int protection, int flags) {
    const off_t end = lseek(descriptor, 0, SEEK_END);
    if (end <= 0) throw raytracer::Error("a descriptor is missing");
    const auto size = static_cast<std::size_t>(end);
    void* memory = mmap(nullptr, size, protection, flags, descriptor, 0);
    if (memory == MAP_FAILED) throw raytracer::Error("a descriptor cannot be mapped");
    return {static_cast<std::byte*>(memory), size};
}

void setSwitches(const ticker::repair::EditRound& round) {
    std::memset(ticker_edit, 0, sizeof ticker_edit);
    for (const std::uint16_t edit : round.edits)
        if (edit < ticker::repair::kMostEdits) ticker_edit[edit] = 1;
    steps = 0;
}

/// Each round builds the same scenes and maps again. Memory that goes back to the kernel in between
/// costs more than the questions.
void keepMemory() {
    constexpr int kMost = 1 << 30;
    mallopt(M_MMAP_THRESHOLD, kMost);
    mallopt(M_TRIM_THRESHOLD, kMost);
}

void answerRounds() {
    using namespace ticker::repair;
    const auto questions =
        ticker::probe::decodeQuestions(mapped(kSwitchedQuestions, PROT_READ, MAP_PRIVATE));
    const std::span<std::byte> rounds = mapped(kSwitchedEdits, PROT_READ, MAP_PRIVATE);
    const std::span<std::byte> memory =
        mapped(kSwitchedAnswers, PROT_READ | PROT_WRITE, MAP_SHARED);
    const std::size_t bytesEach = ticker::probe::layoutFor(questions).totalBytes;
    const std::size_t count = rounds.size() / sizeof(EditRound);
    std::size_t answered = 0;
    const auto measure = [&] {
        std::vector<std::byte> unread(bytesEach);
        ticker::probe::fillUnanswered(unread, ticker::probe::layoutFor(questions));
        ticker::probe::respond(questions, unread);
        mostSteps = kTimesAsOften * steps + kSomeMore;
    };
    for (std::size_t i = 0; i < count; ++i) {
        EditRound round{};
        std::memcpy(&round, rounds.data() + i * sizeof round, sizeof round);
        setSwitches(round);
        if (round.edits[0] == EditRound::kMeasure)
            measure();
        else
            ticker::probe::respond(questions, memory.subspan(bytesEach * answered++, bytesEach));
    }
}

}  // namespace

extern "C" void ticker_step() {
    if (steps.fetch_add(1, std::memory_order_relaxed) > mostSteps)
        throw std::runtime_error("a loop without end");
}

int main() {
    try {
        keepMemory();
        answerRounds();
        _exit(0);
    } catch (const std::exception&) {
        _exit(raytracer::toInt(raytracer::ExitCode::notGradable));
    }
}
