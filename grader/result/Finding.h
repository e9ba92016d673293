#ifndef TICKER_RESULT_FINDING_H
#define TICKER_RESULT_FINDING_H

#include <grader/result/RayDrawing.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ticker {

/// What a finding does to a task: `fail` fails it, `warn` and `note` only inform.
enum class Severity { fail, warn, note };

/// One measured value behind a finding.
using EvidenceValue = std::variant<bool, double, std::string, std::vector<double>>;

/// The measured values behind a finding, in reading order. Keys are camelCase and stable; they
/// appear in result.json.
using Evidence = std::vector<std::pair<std::string, EvidenceValue>>;

/// A point of a scatter plot, in the units that the plot names.
struct PlotPoint {
    double x = 0.0;
    double y = 0.0;
};

/// Observed points and the expected shape: lens samples, aim points.
struct ScatterPlot {
    std::string title;
    std::string unit;  ///< of both axes, for example "world units"
    std::vector<PlotPoint> points;
    enum class Shape { square, disc } expectedShape = Shape::square;
    double expectedHalfWidth = 0.0;  ///< half the square's side, or the disc's radius; centred on 0
    double otherHalfWidth = 0.0;     ///< of another accepted size; 0 if there is no other
    std::optional<RayDrawing> drawing;  ///< rays of one of the pixels or points that are plotted
};

/// A picture made by a judge: a relief, a map of z-scores.
struct Raster {
    std::string title;
    int width = 0;
    int height = 0;
    std::vector<float> values;  ///< width * height, rows from the top; empty in a result read back
    /// grey: 0 is black and 1 is white; diverging: blue below 0, red above, full at -1 and 1.
    enum class Colours { grey, diverging } colours = Colours::grey;
    std::string image = {};  ///< its file under the result's folder; empty before it is drawn
};

/// An observation about a submission, in the student's terms.
struct Finding {
    std::string id;  ///< one of docs/findings.md: "bump.inverted-u"
    Severity severity = Severity::fail;
    /// What was expected and what was observed; one or two sentences, plain text.
    std::string message;
    std::string hint;     ///< where to look: the likely line, the likely step; plain text
    std::string section;  ///< section of the handout: "Option 1: What to do, step 3"
    Evidence evidence;
    std::vector<ScatterPlot> plots;
    std::vector<Raster> rasters;
};

}  // namespace ticker

#endif
