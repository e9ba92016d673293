#ifndef TICKER_SELFTEST_PICTURETRICKS_H
#define TICKER_SELFTEST_PICTURETRICKS_H

#include <grader/metrics/PictureView.h>

#include <cstdint>
#include <functional>

namespace ticker::selftest {

using metrics::ByteView;
using metrics::Picture;

// Changes that students make to pictures before they hand them in.

/// The picture with `change` applied to each channel of each pixel by itself; values from 0 to 1.
[[nodiscard]] Picture recoloured(const ByteView& picture,
                                 const std::function<double(double value, int channel)>& change);
[[nodiscard]] Picture inGrey(const ByteView& picture);
[[nodiscard]] Picture withRedForBlue(const ByteView& picture);
/// The picture on a light canvas of this size, with a dark bar above, as in a viewer's window.
[[nodiscard]] Picture inAWindow(const ByteView& picture, int width, int height);
/// The same pixels, shifted right and down; the border repeats.
[[nodiscard]] Picture moved(const ByteView& picture, int right, int down);
/// The picture with a bright note over its lower right.
[[nodiscard]] Picture withANote(const ByteView& picture);
/// A landscape in natural colours: hills of all sizes. No scene of the exercise looks like it.
[[nodiscard]] Picture photograph(int width, int height, std::uint64_t seed);

}  // namespace ticker::selftest

#endif
