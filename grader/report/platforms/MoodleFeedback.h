#ifndef TICKER_REPORT_MOODLEFEEDBACK_H
#define TICKER_REPORT_MOODLEFEEDBACK_H

#include <grader/report/student/StudentView.h>

#include <string>

namespace ticker::report {

/// What Moodle shows beside the grade: the text for the student as HTML on one line, with the
/// ticker's Markdown rendered. It contains no double quote and no backslash, so that all readers of
/// the CSV agree on where the field ends.
[[nodiscard]] std::string moodleFeedback(const StudentView& view);

}  // namespace ticker::report

#endif
