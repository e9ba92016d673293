#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/answers/LensPlots.h>
#include <grader/tasks/lens/answers/LensShape.h>
#include <grader/tasks/lens/checks/LensChecks.h>
#include <grader/tasks/lens/checks/LensLines.h>
#include <grader/tasks/support/Bounds.h>
#include <grader/tasks/support/FindingOrder.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace ticker::tasks {
namespace {

// Whether the mean of the points is off the eye. The middle of their range is more sensitive for an
// even square, but unreliable for crowded points, whose range depends on outliers. Hoeffding's
// bound for two means of numbers from -half to half.
bool leansAside(const Lens& lens) {
    Vector3 sum;
    for (const Vector3& point : lens.points)
        sum += point;
    const Vector3 mean = sum / static_cast<double>(lens.points.size());
    const double share =
        std::sqrt(2.0 * std::log(4.0 / kStatementRisk) / static_cast<double>(lens.distinct));
    return std::max(std::abs(mean.x), std::abs(mean.y)) > share * lens.halfWidth();
}

// A grid whose points are edges or corners of its cells, not their middles, is off the eye by half
// a cell. No bound on the mean itself tells it from accepted patterns: at the numbers of rays that
// are asked for half a cell is 0.125 to 0.143 of the half-width. The mean of a canonical
// multi-jittered pattern that is cut off lies 0.11 aside (of square cells 0.22), that of R2 0.085,
// Halton 0.08, Hammersley and Sobol 0.065 or less, and that of one random table for all pixels
// beyond 0.125 in one of four. None of these is a grid of a few equal steps. One that was shifted
// by chance lies exactly half a step aside with a chance of 4e-6.
bool isGridAside(const Columns& columns) {
    constexpr double kExact = 1e-6;
    const double halves = 2.0 * std::abs(columns.aside());
    return halves > 0.5 && std::abs(halves - std::round(halves)) < 2.0 * kExact;
}

std::optional<Finding> gridAside(const LensLog& log) {
    const Columns columns = columnsOf(log, &Vector3::x);
    const Columns rows = columnsOf(log, &Vector3::y);
    if (!isGridAside(columns) && !isGridAside(rows)) return std::nullopt;
    Finding finding = distributedFinding(
        kDofOffCentre, Severity::fail,
        fmt::format("An aperture centred on the eye was expected; the grid of lens points lies "
                    "beside the eye, by {:.2g} of a cell in x and {:.2g} in y.",
                    columns.aside(), rows.aside()));
    if (std::max(std::abs(columns.aside()), std::abs(rows.aside())) < 0.75)
        finding.hint =
            "The points are corners or edges of the cells, half a cell from their middles. The "
            "middle of cell i is (i + 0.5) times its width from the edge of the lens: + 0.5 is "
            "missing. Better, draw a random point of each cell anew for every pixel, "
            "i + randomBetween(0, 1) in place of i.";
    return finding;
}

// A hint if one side is far longer than the other: its number was scaled differently, or not at
// all.
std::string hintOfSides(double alongX, double alongY) {
    constexpr double kFar = 1.5;
    if (std::max(alongX, alongY) < kFar * std::min(alongX, alongY)) return {};
    return " x and y are both a random number in [-1, 1] times settings().dofAmount: look for one "
           "that is not scaled, or by something else.";
}

// The accepted half-width that the points fill; 0 if none fits.
double acceptedFactor(const Lens& lens, double amount, double shortfall) {
    for (const double factor : {1.0, 0.5}) {
        const double half = factor * amount;
        if (lens.halfWidth() <= half * (1.0 + 1e-5) && lens.halfWidth() >= half * (1.0 - shortfall))
            return factor;
    }
    return 0.0;
}

// A finding if all rays start in one plane with z other than 0. It comes first, since other faults
// of their places follow from this one.
std::optional<Finding> startsInPlane(const Lens& lens) {
    constexpr double kSlack = 1e-6;
    if (lens.high.z - lens.low.z > kSlack || std::abs(lens.low.z) <= kSlack) return std::nullopt;
    Finding finding = distributedFinding(
        kDofWrong, Severity::fail,
        fmt::format("Every ray was expected to start at a point of the lens, where z is 0; all of "
                    "them start where z is {:.3g}.",
                    lens.low.z));
    finding.hint =
        "A ray starts at the lens point itself: what lies between the lens and the start of a ray "
        "is not seen. Ray{lensPoint, (focalPoint - lensPoint).normalised()} does it.";
    finding.section = "Depth of field (T2.2), step 2";
    return finding;
}

std::optional<Finding> offCentre(const Lens& lens, const ShapeVerdict& shape, double shortfall) {
    const Vector3 centre = lens.centre();
    const double aside = std::max(std::abs(centre.x), std::abs(centre.y));
    const bool isAside = aside > 2.0 * shortfall * lens.halfWidth() + 1e-7;
    if (!isAside || !(shape.square || leansAside(lens))) return std::nullopt;
    return distributedFinding(
        kDofOffCentre, Severity::fail,
        fmt::format("An aperture centred on the eye was expected; its centre is at ({:.3f}, "
                    "{:.3f}).",
                    centre.x, centre.y));
}

std::optional<Finding> notASquare(const Lens& lens, const ShapeVerdict& shape) {
    const double depth = std::max(std::abs(lens.low.z), std::abs(lens.high.z));
    if (depth > 1e-6)
        return distributedFinding(
            kDofDisc, Severity::fail,
            fmt::format("A square in the plane z = 0 was expected; rays start up to {:.3g} in "
                        "front of it or behind it.",
                        depth));
    if (shape.square) return std::nullopt;
    Finding finding = distributedFinding(
        kDofDisc, Severity::fail,
        fmt::format("An evenly filled square was expected; the starting points, up to {:.3g} "
                    "from its centre in x and {:.3g} in y, form another shape ({:.1f} % of "
                    "them outside of the inscribed disc, 21.5 % expected).",
                    0.5 * (lens.high.x - lens.low.x), 0.5 * (lens.high.y - lens.low.y),
                    100.0 * shape.cornerShare));
    finding.hint += hintOfSides(lens.high.x - lens.low.x, lens.high.y - lens.low.y);
    return finding;
}

std::optional<Finding> ofAnotherSize(const Lens& lens, double amount, double factor) {
    if (factor != 0.0) return std::nullopt;
    return distributedFinding(
        kDofApertureSize, Severity::fail,
        fmt::format("A square of half-width {:.3g} (or {:.3g}) was expected; its half-width is "
                    "{:.3g}.",
                    amount, 0.5 * amount, lens.halfWidth()));
}

void addEvidence(Finding& finding, const LensLog& log, const Lens& lens,
                 const ShapeVerdict& shape) {
    const Vector3 centre = lens.centre();
    finding.evidence.emplace_back("halfWidth", lens.halfWidth());
    finding.evidence.emplace_back("centre", std::vector<double>{centre.x, centre.y});
    finding.evidence.emplace_back("shareInCorners", shape.cornerShare);
    finding.evidence.emplace_back("largestGap", shape.gap);
    finding.evidence.emplace_back("points", static_cast<double>(lens.points.size()));
    finding.plots.push_back(plotLens(log));
}

}  // namespace

ApertureVerdict checkAperture(const LensLog& log) {
    ApertureVerdict verdict;
    const Lens lens = lensOf(log);
    if (lens.points.size() < 3) return verdict;
    const double amount = log.asked->settings.dofAmount;
    const double shortfall = rangeShortfall(lens.distinct);
    const ShapeVerdict shape = judgeShape(lens);
    const double factor = acceptedFactor(lens, amount, shortfall);
    // The first of these faults explains those after it.
    verdict.finding = startsInPlane(lens);
    if (!verdict.finding) verdict.finding = checkLines(log, lens, shape);
    if (!verdict.finding) verdict.finding = gridAside(log);
    if (!verdict.finding) verdict.finding = offCentre(lens, shape, shortfall);
    if (!verdict.finding) verdict.finding = notASquare(lens, shape);
    if (!verdict.finding) verdict.finding = ofAnotherSize(lens, amount, factor);
    if (factor != 0.0) verdict.factor = factor;
    if (verdict.finding) addEvidence(*verdict.finding, log, lens, shape);
    return verdict;
}

}  // namespace ticker::tasks
