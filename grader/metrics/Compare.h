#ifndef TICKER_METRICS_COMPARE_H
#define TICKER_METRICS_COMPARE_H

#include <grader/metrics/Noise.h>
#include <grader/metrics/View.h>
#include <grader/metrics/Whereabouts.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::metrics {

/// The numbers that result.json holds of a picture.
struct Scores {
    double flip = 0.0;
    double ssim = 1.0;
    double gmsd = 0.0;
    double rmse = 0.0;  ///< of bytes, 0 to 255
    Map errors;         ///< FLIP of each pixel
};

/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] Scores score(const ByteView& reference, const ByteView& test);

/// One metric's answer, with what a reader has to know of it.
struct Row {
    std::string name;     ///< "flip"; stable
    std::string title;    ///< "FLIP, mean"
    std::string meaning;  ///< "0 equal, 1 as different as can be"
    double value = 0.0;
    Map map;                ///< empty where there is none of its own
    double full = 1.0;      ///< the value that is brightest in a picture of the map
    bool inverted = false;  ///< the map is 1 where the pictures are equal
};

/// What a comparison comes to.
enum class Outcome {
    equal,           ///< every pixel
    nearlyEqual,     ///< so few pixels differ that noise and an edit cannot be told apart
    equalUpToNoise,  ///< no tile differs by more than chance
    different        ///< beyond noise
};

/// The words of `ticker compare --json`: "equal", "nearlyEqual", ...
[[nodiscard]] std::string_view toString(Outcome outcome);

/// Everything that can be said of two pictures.
struct Comparison {
    int width = 0;
    int height = 0;
    std::vector<Row> rows;
    TileTest noise;
    Outcome outcome = Outcome::equal;
    std::optional<Whereabouts> where;  ///< for tiles that differ beyond noise
    std::string sketch;                ///< likewise; some lines for a terminal
    std::string summary;  ///< a sentence or two: the outcome, and where and how much they differ
};

/// @throws raytracer::InputError as `requireSameSize`.
[[nodiscard]] Comparison compare(const ByteView& reference, const ByteView& test,
                                 double pixelsPerDegree);

/// A comparison as a table for a terminal; ends in a newline.
[[nodiscard]] std::string table(const Comparison& comparison);

}  // namespace ticker::metrics

#endif
