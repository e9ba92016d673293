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

/// A failure if two threads render something else than one, and render the pictures that show less
/// alike: what differs there as well belongs to the task before. Empty, too, if something is not
/// rendered at all. Code without variables that calls share always renders alike.
[[nodiscard]] std::optional<Finding> checkThreads(probe::Examinee& examinee, std::uint64_t seed,
                                                  Shows shows, const FindingText& text);

}  // namespace ticker::tasks::maintick

#endif
