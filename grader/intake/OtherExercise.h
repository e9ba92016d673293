#ifndef TICKER_INTAKE_OTHEREXERCISE_H
#define TICKER_INTAKE_OTHEREXERCISE_H

#include <grader/intake/Contents.h>

#include <span>

namespace ticker::intake {

/// The exercise whose files these are, where none of them belongs to `wanted`: a file is told by
/// its name, or, where exercises share the name, by the marks of its tasks. Null: none, or
/// `wanted`.
[[nodiscard]] const Exercise* otherExercise(const Contents& contents, const Exercise& wanted,
                                            std::span<const Exercise> others);

/// The finding for such a submission.
[[nodiscard]] Finding belongsElsewhere(const Exercise& other, const Exercise& wanted);

}  // namespace ticker::intake

#endif
