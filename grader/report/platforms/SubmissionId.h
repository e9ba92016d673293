#ifndef TICKER_REPORT_SUBMISSIONID_H
#define TICKER_REPORT_SUBMISSIONID_H

#include <grader/report/student/StudentView.h>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::report {

/// The digits at the end: "123" of "Participant 123"; empty without digits.
[[nodiscard]] std::string digitsAtEnd(std::string_view text);

/// The platform's id of the person or team, which intake puts at the end of a submission's name:
/// "123" of "Ann Lee_123"; empty if the name has none.
[[nodiscard]] std::string idOf(std::string_view submission);

/// Views by this id, without those that have none. Several where a person was renamed between two
/// downloads: which of them counts is for a person to say.
[[nodiscard]] std::map<std::string, std::vector<std::size_t>> viewsById(
    const std::vector<StudentView>& views);

/// A remark about views that share an id.
inline constexpr std::string_view kSharedId =
    "left out, another submission has the same number: enter the mark by hand";

}  // namespace ticker::report

#endif
