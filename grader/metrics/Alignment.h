#ifndef TICKER_METRICS_ALIGNMENT_H
#define TICKER_METRICS_ALIGNMENT_H

#include <grader/metrics/View.h>

#include <span>

namespace ticker::metrics {

// Pictures of different size and place, brought together. All throw raytracer::InputError where a
// picture is empty or its data is not as long as its size says.

/// The picture at another size. Smaller: each pixel is the mean of the area that it covers.
[[nodiscard]] Picture resized(const ByteView& picture, int width, int height);

enum class Mirror {
    leftRight,
    upDown,
    both  ///< a half turn
};
[[nodiscard]] Picture mirrored(const ByteView& picture, Mirror mirror);

/// Part of a picture, in its pixels.
struct Box {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    friend bool operator==(const Box&, const Box&) = default;
};

/// @throws raytracer::InputError also where the box reaches beyond the picture.
[[nodiscard]] Picture cropped(const ByteView& picture, const Box& box);

/// Pearson's correlation of the grey values, -1 to 1; 0 where a picture is flat. Knows nothing of
/// brightness and contrast.
/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] double correlation(const ByteView& reference, const ByteView& test);

/// Where a part fits into a whole.
struct Fit {
    Box box;                   ///< of the part in the whole
    double correlation = 0.0;  ///< there; 0 where no width was small enough
};

/// Tries the part at several widths, its shape kept, at every place of the whole.
/// @param widths  In pixels of the whole; those at which the part does not fit in are left out.
[[nodiscard]] Fit bestFit(const ByteView& whole, const ByteView& part, std::span<const int> widths);

}  // namespace ticker::metrics

#endif
