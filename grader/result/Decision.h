#ifndef TICKER_RESULT_DECISION_H
#define TICKER_RESULT_DECISION_H

#include <grader/result/SubmissionResult.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace ticker {

/// A ticker's ruling on a submission. The tool proposes, the ticker decides.
enum class Ruling {
    undecided,  ///< also after an undo
    awarded,
    notYet
};

/// Names in the store and in the session's URLs.
inline constexpr std::array<std::pair<Ruling, std::string_view>, 3> kRulingNames{{
    {Ruling::undecided, "undecided"},
    {Ruling::awarded, "awarded"},
    {Ruling::notYet, "notYet"},
}};

/// A ticker's decision about one submission, and what the tool had proposed.
struct Decision {
    std::string submission;
    std::int64_t version = 0;  ///< 0 before the first decision; each decision adds one
    Ruling ruling = Ruling::undecided;
    std::string comment;                      ///< reason; shown to the student
    std::string who;                          ///< the ticker's name; may be empty
    std::string when;                         ///< UTC, "2026-11-21T16:05:36Z"
    Verdict proposed = Verdict::needsReview;  ///< the tool's verdict at that moment
};

}  // namespace ticker

#endif
