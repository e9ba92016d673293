#ifndef TICKER_METRICS_ALIGNMENT_H
#define TICKER_METRICS_ALIGNMENT_H

#include <grader/metrics/PictureView.h>

#include <span>

namespace ticker::metrics {

// Aligns pictures of different size and position. All functions throw raytracer::InputError if a
// picture is empty or its data does not match its size.

/// The picture at another size. When it shrinks, each pixel is the mean of the area that it covers.
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

/// @throws raytracer::InputError also if the box extends beyond the picture.
[[nodiscard]] Picture cropped(const ByteView& picture, const Box& box);

/// Pearson's correlation of the grey values, -1 to 1; 0 if a picture is flat. Independent of
/// brightness and contrast.
/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] double correlation(const ByteView& reference, const ByteView& test);

/// Position and size at which a part fits into a whole picture.
struct Fit {
    Box box;                   ///< of the part in the whole
    double correlation = 0.0;  ///< at the box; 0 if the part fits nowhere
};

/// Tries the part at several widths, with its aspect ratio kept, at every position in the whole.
/// @param widths  In pixels of the whole; widths at which the part is larger than the whole are
///         skipped.
[[nodiscard]] Fit bestFit(const ByteView& whole, const ByteView& part, std::span<const int> widths);

}  // namespace ticker::metrics

#endif
