#ifndef TICKER_REPORT_SOURCELINES_H
#define TICKER_REPORT_SOURCELINES_H

#include <grader/result/SubmissionResult.h>

#include <string>
#include <string_view>
#include <vector>

namespace ticker::report {

[[nodiscard]] std::vector<std::string_view> linesOf(std::string_view text);

/// "File.cpp:12:5: error: what": a line of a compiler's output that points at the file.
struct Remark {
    int line = 0;
    std::string_view kind;  ///< "error" or "warning"
    std::string_view message;
};

/// The errors and warnings of the compiler about the student's file. The texts point into `said`.
[[nodiscard]] std::vector<Remark> remarksOf(const Diagnostics& said);

/// A line between its neighbours as HTML, itself marked; empty where the source has none of this
/// number.
[[nodiscard]] std::string excerpt(const std::vector<std::string_view>& source, int line);

/// The bytes of a file among the result's sources; empty where it is not there.
[[nodiscard]] std::string_view sourceOf(const SubmissionResult& result, std::string_view file);

}  // namespace ticker::report

#endif
