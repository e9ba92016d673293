#ifndef TICKER_TASKS_SCREENSHOT_WHOLE_H
#define TICKER_TASKS_SCREENSHOT_WHOLE_H

#include <grader/metrics/Alignment.h>
#include <grader/tasks/screenshot/Scene.h>

#include <array>

namespace ticker::tasks::screenshot {

// Whole pictures of any sizes, seen from far away: noise, rays within a pixel and the texture of a
// relief are gone. Both must have the handout's shape.

/// Side of the picture in which likeness is measured, pixels.
inline constexpr int kSmallWidth = 160;
inline constexpr int kSmallHeight = 120;

/// From 0.9 upwards for two renders of one scene, whatever the mistakes in them; below 0.82 for any
/// other picture that was tried, a plain ball in the right place among them.
inline constexpr double kSameScene = 0.86;

/// Correlation of brightness at 160 x 120 pixels.
[[nodiscard]] double likeness(const ByteView& reference, const ByteView& picture);

/// How far the colours of 20 x 15 tiles are apart, steps of a byte.
struct TileDifference {
    double rms = 0.0;     ///< root mean square over tiles and channels
    double worst = 0.0;   ///< of one tile, mean over its channels
    double worstX = 0.0;  ///< that tile's middle, as a share of the width
    double worstY = 0.0;
    int tilesOff = 0;  ///< by more than two renders of one scene by one code ever are
};
[[nodiscard]] TileDifference tileDifference(const ByteView& reference, const ByteView& picture);

/// A change of colours: each channel of the result is a quadratic function of each channel.
/// Brightness, contrast and gamma, grey, exchanged channels and negatives are such changes.
class ColourChange {
public:
    static constexpr std::size_t kTerms = 7;  // 1, r, g, b, r^2, g^2, b^2

    /// The change that takes a reference's tiles nearest to a picture's.
    ColourChange(const ByteView& reference, const ByteView& picture);

    [[nodiscard]] Picture appliedTo(const ByteView& picture) const;

private:
    std::array<std::array<double, kTerms>, 3> weights_{};
};

}  // namespace ticker::tasks::screenshot

#endif
