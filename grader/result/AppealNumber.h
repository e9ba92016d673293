#ifndef TICKER_RESULT_APPEALNUMBER_H
#define TICKER_RESULT_APPEALNUMBER_H

#include <grader/result/SubmissionResult.h>

#include <string>

namespace ticker {

/// "1234-5678": names a result to the course's staff, and tells nothing about its seed. Depends on
/// submission, files and seed.
[[nodiscard]] std::string appealNumber(const SubmissionResult& result);

}  // namespace ticker

#endif
