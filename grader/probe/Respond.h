#ifndef TICKER_PROBE_RESPOND_H
#define TICKER_PROBE_RESPOND_H

#include <grader/probe/Question.h>

#include <cstddef>
#include <span>
#include <vector>

namespace ticker::probe {

/// Answers the questions with the solution that this program is linked with, into `memory`, piece
/// by piece: what was answered before a crash stays.
///
/// Exceptions that come out of the solution are counted for each position, point or repetition, the
/// first one's text is kept, and the next one is asked.
///
/// @param memory  As `fillUnanswered` makes it (AnswerMemory.h); aligned to 8.
/// @throws raytracer::Error where the memory is too small.
void respond(const std::vector<Question>& questions, std::span<std::byte> memory);

}  // namespace ticker::probe

#endif
