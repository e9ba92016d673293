#ifndef TICKER_PROBE_ANSWERMEMORY_H
#define TICKER_PROBE_ANSWERMEMORY_H

#include <grader/probe/Question.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

namespace ticker::probe {

/// Both processes compute from the questions where each answer lies in the answer memory:
///   SheetHeader | for each question: AnswerHeader, values (three doubles each) | events
/// Everything before the events is filled with `kUnansweredWord` by the grader.

/// A quiet NaN with a payload that no arithmetic produces. Every 8 bytes hold it until they are
/// written.
inline constexpr std::uint64_t kUnansweredWord = 0x7FF8'7469'636B'2A3FU;

/// Marks that the last question was reached.
inline constexpr std::uint64_t kSheetFinished = 0x646F'6E65'2A2A'2A2AU;

struct SheetHeader {
    std::uint64_t finished = 0;  ///< `kSheetFinished` after the last question
};

/// Written by the submission's process about one question; the grader does not trust it.
struct AnswerHeader {
    static constexpr std::uint32_t kBegun = 3;
    std::uint32_t state = 0;  ///< `kBegun` while the answer is written, then an AnswerState
    std::uint32_t exceptions = 0;
    std::uint32_t wrongSize = 0;
    std::uint32_t reserved = 0;
    std::uint64_t eventsSeen = 0;
    char message[232] = {};
};

static_assert(sizeof(AnswerHeader) == 256 && std::is_trivially_copyable_v<AnswerHeader>);
static_assert(sizeof(Event) == 80 && std::is_trivially_copyable_v<Event>);
static_assert(sizeof(Vector3) == 24 && sizeof(ColourRGB) == 24);

/// Place of one answer, in bytes from the start of the memory.
struct AnswerPlace {
    std::size_t header = 0;
    std::size_t values = 0;
    std::size_t valueCount = 0;  ///< of three doubles each
    std::size_t events = 0;
    std::uint32_t eventCapacity = 0;
    std::uint32_t askCount = 0;  ///< positions, points, rays, calls or repetitions
};

struct AnswerLayout {
    std::vector<AnswerPlace> places;  ///< one for each question
    std::size_t filledBytes = 0;      ///< bytes before the events, filled with `kUnansweredWord`
    std::size_t totalBytes = 0;
};

/// @throws raytracer::Error if the answers need more than 1 GiB.
[[nodiscard]] AnswerLayout layoutFor(const std::vector<Question>& questions);

/// The first `layout.filledBytes` bytes of a memory without answers; the others are zero.
[[nodiscard]] std::vector<std::byte> unanswered(const AnswerLayout& layout);

/// Initialises an answer memory: `memory` has `layout.totalBytes` zero bytes and is aligned to 8.
void fillUnanswered(std::span<std::byte> memory, const AnswerLayout& layout);

/// Copies `to.size()` bytes of an answer memory, from byte `at` on.
using CopyBytes = std::function<void(std::size_t at, std::span<std::byte> to)>;

/// Reads the answers out of the memory, as untrusted input: sizes come from the questions, texts
/// are cut at their first NUL and at 231 bytes, unknown states count as missing, impossible events
/// are dropped.
///
/// @param copy  Copies from a memory of `layoutFor(questions).totalBytes` bytes; the process that
///              wrote them has ended.
[[nodiscard]] std::vector<Answer> readAnswers(const std::vector<Question>& questions,
                                              const CopyBytes& copy);
/// @throws raytracer::Error if `memory` has fewer than `layoutFor(questions).totalBytes` bytes.
[[nodiscard]] std::vector<Answer> readAnswers(const std::vector<Question>& questions,
                                              std::span<const std::byte> memory);

/// True if the other process has set the mark of the last question.
[[nodiscard]] bool saysFinished(const CopyBytes& copy);
[[nodiscard]] bool saysFinished(std::span<const std::byte> memory);

/// True for a part of an answer that was never written, as opposed to a computed NaN.
[[nodiscard]] bool isUnanswered(const Vector3& value);
[[nodiscard]] bool isUnanswered(const ColourRGB& value);

}  // namespace ticker::probe

#endif
