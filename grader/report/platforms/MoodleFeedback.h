#ifndef TICKER_REPORT_MOODLEFEEDBACK_H
#define TICKER_REPORT_MOODLEFEEDBACK_H

#include <grader/report/student/StudentView.h>

#include <string>

namespace ticker::report {

/// What Moodle shows beside the grade: the text for the student as HTML on one line, the ticker's
/// words as their Markdown says. Holds neither quotes nor backslashes of CSV, so that no two
/// readers can differ on where the field ends.
[[nodiscard]] std::string moodleFeedback(const StudentView& view);

}  // namespace ticker::report

#endif
