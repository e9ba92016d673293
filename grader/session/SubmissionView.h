#ifndef TICKER_SESSION_SUBMISSIONVIEW_H
#define TICKER_SESSION_SUBMISSIONVIEW_H

#include <grader/result/SubmissionResult.h>

#include <filesystem>
#include <string>

namespace ticker::session {

/// One submission for the session's page, as HTML: verdict, pictures, tasks with their findings,
/// what the compiler said, the code in colours. Pictures have addresses relative to the page.
/// @param code  `OUT/<submission>/code`
[[nodiscard]] std::string submissionHtml(const SubmissionResult& result,
                                         const std::filesystem::path& code);

}  // namespace ticker::session

#endif
