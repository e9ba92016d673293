#ifndef TICKER_REPORT_REPAIRSECTION_H
#define TICKER_REPORT_REPAIRSECTION_H

#include <grader/result/SubmissionResult.h>

#include <string>

namespace ticker::report {

/// The edits that are proven to mend a failed task, as HTML: the simplest, the others folded away.
/// If edits were looked for and none is proven, it says so; empty if no edits were looked for.
/// Edits that are not proven are left out.
[[nodiscard]] std::string repairSection(const SubmissionResult& result, const TaskReport& task);

/// "An edit in line 12 of File.cpp mends this." if every proven edit of a task is in that one line;
/// else empty.
[[nodiscard]] std::string agreedLine(const SubmissionResult& result, const std::string& task);

}  // namespace ticker::report

#endif
