#ifndef TICKER_REPORT_STUDENTPAGE_H
#define TICKER_REPORT_STUDENTPAGE_H

#include <grader/report/StudentView.h>

#include <string>

namespace ticker::report {

/// One self-contained page for the student: what was found, task by task, what the compiler said,
/// and what the student's own code rendered.
[[nodiscard]] std::string studentPage(const StudentView& view);

}  // namespace ticker::report

#endif
