#ifndef TICKER_TASKS_SCREENSHOT_SEENMISTAKE_H
#define TICKER_TASKS_SCREENSHOT_SEENMISTAKE_H

#include <grader/tasks/screenshot/Scene.h>
#include <grader/tasks/screenshot/Windows.h>

#include <cstdint>
#include <optional>
#include <string>

namespace ticker::tasks::screenshot {

/// What a picture that other code rendered shows.
struct SeenMistake {
    std::string id;  ///< of the catalogue's finding, "shadow.hard"; empty: nothing is wrong in it
    std::string words;  ///< "hard shadows", to go on after "The picture shows"
};

/// Renders the windows with the oracle, under every accepted reading and with every mistake that
/// shows in a picture, and finds the one that the picture agrees with, or that is by far the
/// nearest. Empty where none is.
[[nodiscard]] std::optional<SeenMistake> seenMistake(const ByteView& windowsOfPicture,
                                                     const Scene& scene, const Windows& windows,
                                                     std::uint64_t seed);

}  // namespace ticker::tasks::screenshot

#endif
