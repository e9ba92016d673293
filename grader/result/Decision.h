#ifndef TICKER_RESULT_DECISION_H
#define TICKER_RESULT_DECISION_H

#include <grader/result/SubmissionResult.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace ticker {

/// What a person says about a submission. The tool proposes, a person decides.
enum class Ruling {
    undecided,  ///< also after an undo
    awarded,
    notYet
};

/// The words of the store and of the session's addresses.
inline constexpr std::array<std::pair<Ruling, std::string_view>, 3> kRulingNames{{
    {Ruling::undecided, "undecided"},
    {Ruling::awarded, "awarded"},
    {Ruling::notYet, "notYet"},
}};

/// A person's decision about one submission, beside what the tool had proposed.
struct Decision {
    std::string submission;
    std::int64_t version = 0;  ///< 0: nobody has decided yet; each decision is one more
    Ruling ruling = Ruling::undecided;
    std::string comment;                      ///< why; shown to the student
    std::string who;                          ///< the ticker's name; may be empty
    std::string when;                         ///< UTC, "2026-11-21T16:05:36Z"
    Verdict proposed = Verdict::needsReview;  ///< by the tool, at that moment
};

}  // namespace ticker

#endif
