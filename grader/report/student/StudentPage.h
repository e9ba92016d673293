#ifndef TICKER_REPORT_STUDENT_STUDENTPAGE_H
#define TICKER_REPORT_STUDENT_STUDENTPAGE_H

#include <grader/report/student/StudentView.h>

#include <string>

namespace ticker::report {

/// One self-contained page for the student: the findings of each task, the compiler's messages and
/// the student's own renders.
[[nodiscard]] std::string studentPage(const StudentView& view);

}  // namespace ticker::report

#endif
