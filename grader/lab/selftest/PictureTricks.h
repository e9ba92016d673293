#ifndef TICKER_SELFTEST_PICTURETRICKS_H
#define TICKER_SELFTEST_PICTURETRICKS_H

#include <grader/metrics/View.h>

#include <cstdint>
#include <functional>

namespace ticker::selftest {

using metrics::ByteView;
using metrics::Picture;

// What people do to pictures before they hand them in.

/// Each channel by itself, 0 to 1.
[[nodiscard]] Picture recoloured(const ByteView& picture,
                                 const std::function<double(double value, int channel)>& change);
[[nodiscard]] Picture inGrey(const ByteView& picture);
[[nodiscard]] Picture withRedForBlue(const ByteView& picture);
/// On a light canvas a quarter larger, below a dark bar, as a viewer's window shows it.
[[nodiscard]] Picture inAWindow(const ByteView& picture, int width, int height);
/// The same pixels farther to the right and below; the border repeats.
[[nodiscard]] Picture moved(const ByteView& picture, int right, int down);
/// A bright note stuck on the lower right.
[[nodiscard]] Picture withANote(const ByteView& picture);
/// Hills of all sizes in natural colours: no scene of ours.
[[nodiscard]] Picture photograph(int width, int height, std::uint64_t seed);

}  // namespace ticker::selftest

#endif
