#ifndef TICKER_REPORT_REPORTPAGE_H
#define TICKER_REPORT_REPORTPAGE_H

#include <grader/result/SubmissionResult.h>

#include <string>

namespace ticker::report {

/// The text of report.html: one self-contained page about one submission, pictures included. It
/// needs no network and no other files.
[[nodiscard]] std::string reportPage(const SubmissionResult& result);

}  // namespace ticker::report

#endif
