#ifndef TICKER_SESSION_SUBMISSIONVIEW_H
#define TICKER_SESSION_SUBMISSIONVIEW_H

#include <grader/result/SubmissionResult.h>

#include <filesystem>
#include <string>

namespace ticker::session {

/// One submission for the session's page, as HTML: verdict, what the compiler said beside the
/// student's lines, pictures, tasks with their findings, the code in colours. Pictures have
/// addresses relative to the page.
/// @param code  `OUT/<submission>/code`
[[nodiscard]] std::string submissionHtml(SubmissionResult result,
                                         const std::filesystem::path& code);

}  // namespace ticker::session

#endif
