#include <grader/tasks/bump/places/OwnTexels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace ticker::tasks::bump {
namespace {

// A hundredth of the map, the widest accepted step of u and v, stays within a texel.
constexpr int kColumns = 60;
constexpr int kRows = 30;

/// A point's own texel, and the slope along one axis that its tilt shows.
struct Shown {
    int column;
    int row;
    double slope;
};

/// Squared correlation of the slopes with the texels that lie `columns` and `rows` away.
double shareOf(const probe::HeightMapDescription& map, const std::vector<Shown>& shown, int columns,
               int rows) {
    constexpr double kMiddle = 127.5;
    double both = 0.0;
    double size = 0.0;
    double heights = 0.0;
    for (const Shown& at : shown) {
        const int row = at.row + rows;
        if (row < 0 || row >= kRows) continue;
        const int column = (at.column + columns + kColumns) % kColumns;
        const double height =
            map.bytes[static_cast<std::size_t>(row * kColumns + column)] - kMiddle;
        both += at.slope * height;
        size += at.slope * at.slope;
        heights += height * height;
    }
    return size > 0.0 ? both * both / (size * heights) : 0.0;
}

/// @param most     The farthest line.
/// @param shareAt  The share of the texel so many lines away, and so many texels along its line.
template <typename ShareAt>
FarLine farLine(int most, ShareAt shareAt) {
    constexpr int kMostAlong = 4;
    FarLine line;
    for (int away = -most; away <= most; ++away) {
        if (std::abs(away) < 2) continue;
        double share = 0.0;
        for (int along = -kMostAlong; along <= kMostAlong; ++along)
            share += shareAt(away, along);
        if (share > line.share) line = {share, away};
    }
    return line;
}

}  // namespace

OwnTexelPlan planOwnTexels(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    constexpr int kPoints = 2000;
    OwnTexelPlan plan{draws.directions(kPoints), {}};
    plan.noise = questionnaire.addPair(ball, noiseMap(draws, kColumns, kRows), plan.directions);
    return plan;
}

OwnTexels readOwnTexels(const OwnTexelPlan& plan, const Answers& answers,
                        const Parametrisation& parametrisation, const Response& response) {
    constexpr int kMostRows = 7;
    constexpr int kMostColumns = 10;
    const probe::HeightMapDescription& map = answers.asked().question(plan.noise.map).map;
    const std::vector<Vector3> tilts = answers.tiltsBeyond(plan.noise.flat, plan.noise.map);
    std::vector<Shown> onU;
    std::vector<Shown> onV;
    for (std::size_t i = 0; i < tilts.size(); ++i) {
        const Vector3& n = plan.directions[i];
        if (!isOrdinary(parametrisation, n) || !isFinite(tilts[i])) continue;
        const double v = parametrisation.v(n);
        const int column = static_cast<int>(parametrisation.u(n) * kColumns);
        const int row = static_cast<int>(v * kRows);
        // Divided by the code's own strength, so that all latitudes weigh alike.
        onU.push_back(
            {column, row, tilts[i].dot(parametrisation.alongU(n)) / strengthAt(response.u, v)});
        onV.push_back(
            {column, row, tilts[i].dot(parametrisation.alongV(n)) / strengthAt(response.v, v)});
    }
    return {
        farLine(kMostRows, [&](int away, int along) { return shareOf(map, onU, along, away); }),
        farLine(kMostColumns, [&](int away, int along) { return shareOf(map, onV, away, along); })};
}

}  // namespace ticker::tasks::bump
