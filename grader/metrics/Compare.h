#ifndef TICKER_METRICS_COMPARE_H
#define TICKER_METRICS_COMPARE_H

#include <grader/metrics/Noise.h>
#include <grader/metrics/PictureView.h>
#include <grader/metrics/Whereabouts.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::metrics {

/// The metrics of a picture that result.json holds.
struct Scores {
    double flip = 0.0;
    double ssim = 1.0;
    double gmsd = 0.0;
    double rmse = 0.0;  ///< of bytes, 0 to 255
    Map errors;         ///< FLIP of each pixel
};

/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] Scores score(const ByteView& reference, const ByteView& test);

/// The result of one metric, with its explanation for readers.
struct Row {
    std::string name;     ///< "flip"; stable
    std::string title;    ///< "FLIP, mean"
    std::string meaning;  ///< "0 equal, 1 black against white"
    double value = 0.0;
    Map map;                ///< empty if the metric has no map of its own
    double full = 1.0;      ///< value of the brightest colour in a picture of the map
    bool inverted = false;  ///< the map is 1 where the pictures are equal
};

/// The result of a comparison.
enum class Outcome {
    equal,           ///< every pixel is equal
    nearlyEqual,     ///< so few pixels differ that noise cannot be told from an edit
    equalUpToNoise,  ///< no tile differs by more than chance
    different        ///< beyond noise
};

/// The words of `ticker compare --json`: "equal", "nearlyEqual", ...
[[nodiscard]] std::string_view toString(Outcome outcome);

/// The complete comparison of two pictures.
struct Comparison {
    int width = 0;
    int height = 0;
    std::vector<Row> rows;
    TileTest noise;
    Outcome outcome = Outcome::equal;
    std::optional<Whereabouts> where;  ///< if some tiles differ beyond noise
    std::string sketch;                ///< likewise; a few lines for a terminal
    std::string summary;  ///< one or two sentences: the outcome, and where and how much they differ
};

/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] Comparison compare(const ByteView& reference, const ByteView& test,
                                 double pixelsPerDegree);

/// A comparison as a table for a terminal; ends in a newline.
[[nodiscard]] std::string table(const Comparison& comparison);

}  // namespace ticker::metrics

#endif
