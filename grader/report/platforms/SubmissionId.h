#ifndef TICKER_REPORT_SUBMISSIONID_H
#define TICKER_REPORT_SUBMISSIONID_H

#include <string>
#include <string_view>

namespace ticker::report {

/// The digits at the end: "123" of "Participant 123"; empty without digits.
[[nodiscard]] std::string digitsAtEnd(std::string_view text);

/// The platform's id of the person or team, which intake puts at the end of a submission's name:
/// "123" of "Ann Lee_123"; empty if the name has none.
[[nodiscard]] std::string idOf(std::string_view submission);

}  // namespace ticker::report

#endif
