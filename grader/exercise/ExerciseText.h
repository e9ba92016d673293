#ifndef TICKER_EXERCISE_EXERCISETEXT_H
#define TICKER_EXERCISE_EXERCISETEXT_H

namespace ticker {

/// The texts of the exercises' files, in a source that CMake writes; the last one is null.
extern const char* const kExerciseTexts[];

}  // namespace ticker

#endif
