#ifndef TICKER_RESULT_PROVENLINE_H
#define TICKER_RESULT_PROVENLINE_H

#include <grader/result/SubmissionResult.h>

#include <string>
#include <string_view>
#include <vector>

namespace ticker {

/// A line of a submission whose edit is proven to make a failed task pass.
struct ProvenLine {
    std::string task;
    std::string file;
    int line = 0;      ///< counted from 1
    std::string from;  ///< untrusted: the student's text, without spaces at its ends
    std::string to;

    bool operator==(const ProvenLine&) const = default;
};

/// The lines of the first proven edit of each task that passes with it.
[[nodiscard]] std::vector<ProvenLine> provenLines(const SubmissionResult& result);

/// Proven lines as text for the store, a JSON array; empty for none. And back: what is no such text
/// is left out.
[[nodiscard]] std::string provenText(const std::vector<ProvenLine>& lines);
[[nodiscard]] std::vector<ProvenLine> readProven(std::string_view text);

}  // namespace ticker

#endif
