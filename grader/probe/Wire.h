#ifndef TICKER_PROBE_WIRE_H
#define TICKER_PROBE_WIRE_H

#include <grader/probe/Question.h>

#include <cstddef>
#include <span>
#include <vector>

namespace ticker::probe {

/// The message that carries questions to the probe program.
/// @throws raytracer::Error if a question contradicts itself (a map of another size than stated, a
///         point on an object that does not exist, an image without pixels).
[[nodiscard]] std::vector<std::byte> encodeQuestions(const std::vector<Question>& questions);

/// Reads the message back.
/// @throws raytracer::Error if it is truncated, of another version, or contradicts itself.
[[nodiscard]] std::vector<Question> decodeQuestions(std::span<const std::byte> message);

}  // namespace ticker::probe

#endif
