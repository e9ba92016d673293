#ifndef TICKER_PROBE_RESPOND_H
#define TICKER_PROBE_RESPOND_H

#include <grader/probe/Question.h>

#include <cstddef>
#include <span>
#include <vector>

namespace ticker::probe {

/// Answers the questions with the solution that this program is linked with, writing into `memory`
/// as it goes: answers given before a crash are kept.
///
/// An exception of the solution is counted for its position, point or repetition; the text of the
/// first one is kept, and the next item is asked.
///
/// @param memory  Filled by `fillUnanswered` (AnswerMemory.h); aligned to 8.
/// @throws raytracer::Error if the memory is too small, or if a question names a call that the
///         exercise does not have.
void respond(const std::vector<Question>& questions, std::span<std::byte> memory);

}  // namespace ticker::probe

#endif
