#ifndef TICKER_SESSION_SUBMISSIONVIEW_H
#define TICKER_SESSION_SUBMISSIONVIEW_H

#include <grader/result/SubmissionResult.h>
#include <grader/store/Earlier.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::session {

/// What was found, in a line each and once, as HTML; empty where nothing was.
[[nodiscard]] std::string toldHtml(const SubmissionResult& result);

/// One submission for the session's page, as HTML: verdict, pictures, and beside each other what
/// was found (the compiler's words, tasks with their findings) and the code, in which the lines
/// that something points at are marked; earlier results of it. Pictures have addresses relative to
/// the page.
/// @param code  `OUT/<submission>/code`
[[nodiscard]] std::string submissionHtml(SubmissionResult result, const std::filesystem::path& code,
                                         const std::vector<store::Earlier>& earlier = {});

}  // namespace ticker::session

#endif
