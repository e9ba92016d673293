#ifndef TICKER_METRICS_WHEREABOUTS_H
#define TICKER_METRICS_WHEREABOUTS_H

#include <grader/metrics/Noise.h>

#include <string>

namespace ticker::metrics {

/// A rectangle of pixels, and the difference of two pictures in it.
struct Patch {
    int left = 0;
    int top = 0;
    int right = 0;                ///< one beyond the last column
    int bottom = 0;               ///< one beyond the last row
    double meanDifference = 0.0;  ///< test minus reference, bytes, over all channels
    double rmse = 0.0;            ///< bytes
};

/// Where two pictures differ, from the tiles that differ beyond noise.
struct Whereabouts {
    Patch box;          ///< the middle four fifths of these tiles in x and y; their differences
    Patch worst;        ///< the tile that differs most
    std::string words;  ///< "around the centre", "towards the top left"
};

/// @param noise  Of the same two pictures; at least one of its tiles differs.
[[nodiscard]] Whereabouts whereabouts(const ByteView& reference, const ByteView& test,
                                      const TileTest& noise);

/// The tiles as a few lines for a terminal: "." if equal up to noise, "+" and "-" if the test
/// picture is brighter or darker, "~" if it differs in detail alone.
[[nodiscard]] std::string sketch(const ByteView& reference, const ByteView& test,
                                 const TileTest& noise);

}  // namespace ticker::metrics

#endif
