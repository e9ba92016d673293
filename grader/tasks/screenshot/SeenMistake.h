#ifndef TICKER_TASKS_SCREENSHOT_SEENMISTAKE_H
#define TICKER_TASKS_SCREENSHOT_SEENMISTAKE_H

#include <grader/tasks/screenshot/ShownScene.h>
#include <grader/tasks/screenshot/Windows.h>

#include <cstdint>
#include <optional>
#include <string>

namespace ticker::tasks::screenshot {

/// The mistake that a picture by other code shows.
struct SeenMistake {
    std::string id;     ///< id of the finding, "shadow.hard"; empty if the picture is right
    std::string words;  ///< words that continue "The picture shows": "hard shadows"
};

/// Renders the windows with the oracle, under every accepted reading and with every mistake that is
/// visible in a picture. Returns the one that agrees with the picture, or is by far the nearest;
/// empty if none is.
[[nodiscard]] std::optional<SeenMistake> seenMistake(const ByteView& windowsOfPicture,
                                                     const Scene& scene, const Windows& windows,
                                                     std::uint64_t seed);

}  // namespace ticker::tasks::screenshot

#endif
