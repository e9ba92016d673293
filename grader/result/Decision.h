#ifndef TICKER_RESULT_DECISION_H
#define TICKER_RESULT_DECISION_H

#include <grader/result/SubmissionResult.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

/// What a ticker says about one line of a student's file.
struct LineNote {
    std::string file;  ///< its name
    int line = 0;      ///< counted from 1
    std::string code;  ///< that line, as it was
    std::string text;  ///< Markdown, for the student

    bool operator==(const LineNote&) const = default;
};

/// A ticker's decision about one submission, and what the tool had proposed.
struct Decision {
    std::string submission;
    std::int64_t version = 0;  ///< 0 before the first decision; each decision adds one
    Ruling ruling = Ruling::undecided;
    std::string comment;                      ///< reason; Markdown, shown to the student
    std::string who;                          ///< the ticker's name; may be empty
    std::string when;                         ///< UTC, "2026-11-21T16:05:36Z"
    Verdict proposed = Verdict::needsReview;  ///< the tool's verdict at that moment
    std::vector<LineNote> notes = {};         ///< shown to the student
    std::string bulk = {};   ///< identifies a bulk decision; empty for a single one
    std::string files = {};  ///< digest of the files that it is about; empty: unknown
};

/// Line notes as text for the store and the session's page, a JSON array; and back. What is no such
/// text, and notes without a file, a line or words, are left out.
[[nodiscard]] std::string notesText(const std::vector<LineNote>& notes);
[[nodiscard]] std::vector<LineNote> readNotes(std::string_view text);

}  // namespace ticker

#endif
