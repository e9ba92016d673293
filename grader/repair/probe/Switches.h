#ifndef TICKER_REPAIR_PROBE_SWITCHES_H
#define TICKER_REPAIR_PROBE_SWITCHES_H

#include <cstddef>
#include <cstdint>

namespace ticker::repair {

/// Descriptors of a program with switched edits: the probe's two, and one for the switches.
inline constexpr int kSwitchedQuestions = 3;
inline constexpr int kSwitchedAnswers = 4;
inline constexpr int kSwitchedEdits = 5;

/// Most edits of a program.
inline constexpr std::size_t kMostEdits = 4096;

/// One round of questions: the edits that are made in it; `kNoEdit` where there are fewer. A first
/// round of `kMeasure` has no edit and no memory for answers: it counts how often loops go round.
struct EditRound {
    static constexpr std::uint16_t kNoEdit = 0xFFFF;
    static constexpr std::uint16_t kMeasure = 0xFFFE;
    static constexpr std::size_t kMost = 8;
    std::uint16_t edits[kMost];
};

}  // namespace ticker::repair

#endif
