#ifndef TICKER_SESSION_EARLIERVIEW_H
#define TICKER_SESSION_EARLIERVIEW_H

#include <grader/store/Earlier.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::session {

/// The earlier results of a submission as HTML, each compared with the next one: verdict, removed
/// and new findings, and a diff of the code. Empty without earlier results.
/// @param code  Folder of the current sources.
[[nodiscard]] std::string earlierHtml(const SubmissionResult& now,
                                      const std::filesystem::path& code,
                                      const std::vector<store::Earlier>& earlier);

/// A line for the submission's head: what was handed in before, what has changed, and a button that
/// leads to the rest. Empty without earlier results.
[[nodiscard]] std::string earlierLine(const SubmissionResult& now,
                                      const std::vector<store::Earlier>& earlier);

}  // namespace ticker::session

#endif
