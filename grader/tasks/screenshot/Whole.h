#ifndef TICKER_TASKS_SCREENSHOT_WHOLE_H
#define TICKER_TASKS_SCREENSHOT_WHOLE_H

#include <grader/metrics/Alignment.h>
#include <grader/tasks/screenshot/ShownScene.h>

#include <array>

namespace ticker::tasks::screenshot {

// Compares whole pictures of any size at low resolution, without noise, antialiasing and the
// texture of a relief. Both must have the handout's shape.

/// Size at which likeness is measured, pixels.
inline constexpr int kSmallWidth = 160;
inline constexpr int kSmallHeight = 120;

/// Two renders of one scene have at least 0.9, whatever their mistakes. All other tried pictures
/// stay below 0.82, including a plain ball in the right place.
inline constexpr double kSameScene = 0.86;

/// Correlation of brightness at 160 x 120 pixels.
[[nodiscard]] double likeness(const ByteView& reference, const ByteView& picture);

/// Colour differences of 20 x 15 tiles, steps of a byte.
struct TileDifference {
    double rms = 0.0;     ///< root mean square over tiles and channels
    double worst = 0.0;   ///< of the worst tile, mean over its channels
    double worstX = 0.0;  ///< that tile's centre, as a share of the width
    double worstY = 0.0;
    int tilesOff = 0;  ///< differing by more than two renders by one code ever do
};
[[nodiscard]] TileDifference tileDifference(const ByteView& reference, const ByteView& picture);

/// A change of colours: each channel of the result is a quadratic function of all channels. It
/// covers brightness, contrast and gamma, grey, exchanged channels and negatives.
class ColourChange {
public:
    static constexpr std::size_t kTerms = 7;  // 1, r, g, b, r^2, g^2, b^2

    /// The change that fits a reference's tiles best to a picture's.
    ColourChange(const ByteView& reference, const ByteView& picture);

    [[nodiscard]] Picture appliedTo(const ByteView& picture) const;

private:
    std::array<std::array<double, kTerms>, 3> weights_{};
};

}  // namespace ticker::tasks::screenshot

#endif
