#ifndef TICKER_TASKS_MAINTICK_THREADS_H
#define TICKER_TASKS_MAINTICK_THREADS_H

#include <grader/probe/Examinee.h>
#include <grader/result/FindingText.h>
#include <grader/result/SubmissionResult.h>

#include <cstdint>
#include <optional>

namespace ticker::tasks::maintick {

/// What a picture shows besides a floor in the light of two lamps.
enum class Shows : std::uint8_t { floor, shadows, mirrors };

/// Fails if two threads render another picture than one thread. Empty if that happens in a picture
/// that shows less, too, since the mistake is then one of an earlier task. Also empty if a picture
/// is missing. Code whose calls share no variable never fails.
[[nodiscard]] std::optional<Finding> checkThreads(probe::Examinee& examinee, std::uint64_t seed,
                                                  Shows shows, const FindingText& text);

}  // namespace ticker::tasks::maintick

#endif
