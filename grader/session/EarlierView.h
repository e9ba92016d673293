#ifndef TICKER_SESSION_EARLIERVIEW_H
#define TICKER_SESSION_EARLIERVIEW_H

#include <grader/store/Earlier.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::session {

/// The earlier results of a submission as HTML, each beside what replaced it: verdict, findings
/// that went and came, and a diff of the code. Empty if there are none.
/// @param code  Folder of the newest sources.
[[nodiscard]] std::string earlierHtml(const SubmissionResult& now,
                                      const std::filesystem::path& code,
                                      const std::vector<store::Earlier>& earlier);

}  // namespace ticker::session

#endif
