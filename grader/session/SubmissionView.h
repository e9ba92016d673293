#ifndef TICKER_SESSION_SUBMISSIONVIEW_H
#define TICKER_SESSION_SUBMISSIONVIEW_H

#include <grader/result/SubmissionResult.h>
#include <grader/store/Earlier.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::session {

/// The findings as an HTML list, without repetitions; empty without findings.
[[nodiscard]] std::string toldHtml(const SubmissionResult& result);

/// One submission for the session's page, as HTML: verdict; pictures; the compiler's messages and
/// the findings of each task beside the code, with marked lines (`markedLines`); earlier results.
/// Addresses of pictures are relative to the page.
/// @param code  `OUT/<submission>/code`
[[nodiscard]] std::string submissionHtml(SubmissionResult result, const std::filesystem::path& code,
                                         const std::vector<store::Earlier>& earlier = {});

}  // namespace ticker::session

#endif
