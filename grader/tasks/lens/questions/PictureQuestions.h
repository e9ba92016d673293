#ifndef TICKER_TASKS_LENS_QUESTIONS_PICTUREQUESTIONS_H
#define TICKER_TASKS_LENS_QUESTIONS_PICTUREQUESTIONS_H

#include <grader/probe/Question.h>

#include <cstdint>

namespace ticker::tasks {

/// A question for code whose rays are not visible: a scene without lights, at the handout's
/// settings, without a log. Only the pictures are judged.
/// @param onePicture  One large picture in place of several small ones: for code that repeats its
///                    pictures.
[[nodiscard]] probe::RenderQuestion drawPictureQuestion(std::uint64_t seed,
                                                        bool onePicture = false);

/// Pixels are smaller by this factor in a fine picture.
inline constexpr double kFinerPixels = 2.0;

/// The same in smaller pixels, for code whose pictures look antialiased.
[[nodiscard]] probe::RenderQuestion drawFinePictureQuestion(std::uint64_t seed);

}  // namespace ticker::tasks

#endif
