#include <bump/AxisAnswers.h>
#include <bump/BumpSurvey.h>
#include <questions/BumpQuestions.h>
#include <raytracer/geometry/BumpySphere.h>
#include <support/TestDraws.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <memory>

namespace raytracer::tests::bump {
namespace {

constexpr int kPoints = 240;
// Radians between neighbours: large compared with a texel, small compared with the sphere.
constexpr double kStep = 0.1;

// Neither at the origin nor of radius 1, and so large that heights are small beside it.
const Vector3 kCentre{1.3, -0.7, 25.0};
constexpr double kRadius = 14.0;

/// A point and its four neighbours in two directions at a right angle.
constexpr std::size_t kInGroup = 5;

struct Frame {
    Vector3 first;
    Vector3 second;
};

Frame frameAt(const Vector3& direction) {
    const Vector3 other = std::abs(direction.x) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
    const Vector3 first = direction.cross(other).normalised();
    return {first, direction.cross(first)};
}

std::vector<Vector3> groupsAround(const std::vector<Vector3>& middles) {
    std::vector<Vector3> all;
    for (const Vector3& middle : middles) {
        const Frame frame = frameAt(middle);
        all.push_back(middle);
        for (const Vector3& side : {frame.first, -frame.first, frame.second, -frame.second})
            all.push_back((middle + side * std::tan(kStep)).normalised());
    }
    return all;
}

/// Finds the direction on the sphere in which the place on the map grows at the middle point of a
/// group. False if the neighbours' places are not finite, equal, or too far apart.
/// @param goesRound  The axis is periodic.
bool readAxis(const AxisAnswers& answers, std::size_t group, const Frame& frame, bool goesRound,
              AxisAtPoint& axis) {
    const std::size_t at = group * kInGroup;
    const auto growth = [&](std::size_t plus, std::size_t minus) {
        const double apart = answers.places[at + plus] - answers.places[at + minus];
        return goesRound ? std::remainder(apart, 1.0) : apart;
    };
    constexpr double kClear = 0.25;  // of the map; a larger difference is the map's edge
    const double first = growth(1, 2);
    const double second = growth(3, 4);
    if (!(std::abs(first) < kClear && std::abs(second) < kClear)) return false;
    const Vector3 gradient = (frame.first * first + frame.second * second) / (2.0 * kStep);
    axis.place = answers.places[at];
    axis.pace = gradient.magnitude();
    axis.along = gradient.normalised();
    axis.tilt = answers.tilts[at];
    return axis.pace > 0.0 && std::isfinite(axis.place);
}

double middleLength(const std::vector<Vector3>& tilts) {
    std::vector<double> lengths;
    for (const Vector3& tilt : tilts)
        lengths.push_back(tilt.magnitude());
    return median(lengths);
}

}  // namespace

double median(std::vector<double> values) {
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

HeightMap mapOf(const std::vector<double>& columns, const std::vector<double>& rows) {
    std::vector<double> heights;
    for (const double row : rows)
        for (const double column : columns)
            heights.push_back(std::clamp(row + column, 0.0, kBumpFactor));
    return {static_cast<int>(columns.size()), static_cast<int>(rows.size()), std::move(heights)};
}

const BumpySphere& keptSphere(const Vector3& centre, double radius, const HeightMap& map) {
    static std::deque<BumpySphere> kept;
    return kept.emplace_back(centre, radius, Material{}, std::make_shared<const HeightMap>(map));
}

std::vector<Vector3> tiltsOn(const HeightMap& map, const std::vector<Vector3>& directions) {
    const BumpySphere& sphere = keptSphere(kCentre, kRadius, map);
    std::vector<Vector3> tilts;
    for (const Vector3& direction : directions)
        tilts.push_back(
            questions::tiltOf(sphere.getNormalAt(kCentre + direction * kRadius), direction));
    return tilts;
}

std::vector<Vector3> tiltsBeyondFlat(const HeightMap& map, const std::vector<Vector3>& directions) {
    const std::vector<double> columns = questions::level(map.width(), 0.5);
    const std::vector<Vector3> flat =
        tiltsOn(mapOf(columns, questions::level(map.height())), directions);
    std::vector<Vector3> tilts = tiltsOn(map, directions);
    for (std::size_t i = 0; i < tilts.size(); ++i)
        tilts[i] -= flat[i];
    return tilts;
}

BumpSurvey::BumpSurvey(const Slope& slope) : slope_(slope), asked_(kPoints) {
    Draws draws{20};
    std::vector<Vector3> middles;
    for (int i = 0; i < kPoints; ++i)
        middles.push_back(draws.direction());
    const std::vector<Vector3> directions = groupsAround(middles);
    const AxisAnswers alongU = askAlong(true, slope, directions);
    const AxisAnswers alongV = askAlong(false, slope, directions);
    for (std::size_t group = 0; group < middles.size(); ++group) {
        SurveyPoint point;
        point.direction = middles[group];
        const Frame frame = frameAt(point.direction);
        if (readAxis(alongU, group, frame, true, point.u) &&
            readAxis(alongV, group, frame, false, point.v))
            points_.push_back(point);
    }
    strengthU_ = middleLength(alongU.tilts);
    strengthV_ = middleLength(alongV.tilts);
    strengthOnFlat_ = middleLength(tiltsOn(
        mapOf(questions::level(kRampTexels, 2.5), questions::level(kRampTexels / 2)), middles));
}

bool BumpSurvey::isLevel() const {
    constexpr double kSomething = 1e-6;  // radians
    return !(std::min(strengthU_, strengthV_) > kSomething);
}

Vector3 BumpSurvey::top() const {
    Vector3 down;
    for (const SurveyPoint& point : points_)
        down += point.v.along;
    return -down.normalised();
}

}  // namespace raytracer::tests::bump
