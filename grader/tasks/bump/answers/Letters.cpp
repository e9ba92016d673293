#include <grader/tasks/bump/answers/Letters.h>

#include <grader/tasks/bump/answers/LetterCells.h>
#include <grader/tasks/bump/answers/Poisson.h>
#include <grader/tasks/bump/questions/LetterMap.h>
#include <grader/tasks/bump/questions/Numbers.h>
#include <grader/tasks/bump/questions/Slopes.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ticker::tasks::bump {
namespace {

/// Height differences from one cell to a neighbour.
struct Step {
    double trueU = 0.0;  // by the map's slope along u alone
    double trueV = 0.0;
    double seen = 0.0;
};

Step stepBetween(const Cell& from, const Cell& to) {
    const double columns = std::remainder(to.column - from.column, kLetterMapWidth);
    const double rows = to.row - from.row;
    return {0.5 * (from.trueU + to.trueU) * columns, 0.5 * (from.trueV + to.trueV) * rows,
            0.5 * ((from.seenU + to.seenU) * columns + (from.seenV + to.seenV) * rows)};
}

constexpr double kFull = 0.95;  // of the letter's height
constexpr double kNone = 0.05;
// A change below this share of the true one counts as no change. The exact normal of the displaced
// surface keeps less of an H, which stands high, than of an L.
constexpr double kSure = 0.1;

/// Follows one row or column of the grid and counts the edges that it crosses.
class Path {
public:
    explicit Path(LetterReading& reading) : reading_(reading) {}

    void follow(const Cell& from, const Cell& to) {
        if (isLevel(from)) start_ = &from;
        if (isLevel(from)) sum_ = {};
        const Step step = stepBetween(from, to);
        sum_.trueU += step.trueU;
        sum_.trueV += step.trueV;
        sum_.seen += step.seen;
        if (start_ != nullptr && isLevel(to) && isFull(*start_) != isFull(to))
            count(isFull(to) ? to.kind : start_->kind, to.height - start_->height);
    }

private:
    static bool isFull(const Cell& cell) { return std::abs(cell.height) >= kFull; }
    static bool isLevel(const Cell& cell) { return isFull(cell) || std::abs(cell.height) <= kNone; }

    void count(Letter kind, double change) {
        // A crossing counts for an axis if most of its height change comes from that axis alone.
        constexpr double kMostly = 0.8;
        LetterCount& letter = kind == Letter::h ? reading_.h : reading_.l;
        const bool alongU = std::abs(sum_.trueU) > kMostly;
        const bool alongV = std::abs(sum_.trueV) > kMostly;
        if (alongU == alongV) return;
        EdgeCount& edges = alongU ? letter.alongU : letter.alongV;
        const double share = sum_.seen / change;
        if (share >= kSure)
            ++edges.right;
        else if (share <= -kSure)
            ++edges.opposite;
        else
            ++edges.lost;
    }

    LetterReading& reading_;
    const Cell* start_ = nullptr;
    Step sum_;
};

std::size_t cellIndex(int column, int row) {
    return static_cast<std::size_t>(row * LetterPlan::kColumns + column);
}

LetterReading countEdges(const CellGrid& grid) {
    LetterReading reading;
    for (int row = 0; row < LetterPlan::kRows; ++row) {
        Path path(reading);
        for (int column = 0; column + 1 < LetterPlan::kColumns; ++column)
            path.follow(grid[cellIndex(column, row)], grid[cellIndex(column + 1, row)]);
    }
    for (int column = 0; column < LetterPlan::kColumns; ++column) {
        Path path(reading);
        for (int row = 0; row + 1 < LetterPlan::kRows; ++row)
            path.follow(grid[cellIndex(column, row)], grid[cellIndex(column, row + 1)]);
    }
    return reading;
}

GridDifferences differencesOf(const CellGrid& grid) {
    GridDifferences differences{LetterPlan::kColumns, LetterPlan::kRows,
                                std::vector<double>(grid.size(), 0.0),
                                std::vector<double>(grid.size(), 0.0)};
    for (int row = 0; row < LetterPlan::kRows; ++row)
        for (int column = 0; column < LetterPlan::kColumns; ++column) {
            const std::size_t cell = cellIndex(column, row);
            if (column + 1 < LetterPlan::kColumns)
                differences.right[cell] = stepBetween(grid[cell], grid[cell + 1]).seen;
            if (row + 1 < LetterPlan::kRows)
                differences.down[cell] =
                    stepBetween(grid[cell], grid[cellIndex(column, row + 1)]).seen;
        }
    return differences;
}

Raster raster(const std::string& title, const std::vector<double>& heights) {
    Raster picture{title, LetterPlan::kColumns, LetterPlan::kRows, {}, Raster::Colours::grey};
    const double ground = median(heights);
    picture.values.reserve(heights.size());
    for (const double height : heights)
        picture.values.push_back(
            static_cast<float>(std::clamp(0.5 + 0.4 * (height - ground), 0.0, 1.0)));
    return picture;
}

/// False if many edges have the wrong sign, or if hardly any has the right one. A low share of
/// right edges alone does not fail: the ramps have shown on larger spheres that slopes tilt, and
/// coarse sampling may miss many of these short edges, though it finds those of a larger map.
bool agrees(const EdgeCount& edges) {
    constexpr int kOneOf = 20;
    return 9 * edges.opposite <= edges.right && kOneOf * edges.right >= edges.crossed();
}

bool agrees(const LetterCount& count) {
    return agrees(count.alongU) && agrees(count.alongV);
}

}  // namespace

LetterPlan planLetters(Questionnaire& questionnaire, Draws& draws) {
    LetterPlan plan;
    // The steps are no simple fraction of a texel, so that grid points fall anywhere within texels.
    const double width = draws.uniform(0.975, 0.985) * std::numbers::pi;
    const double height = draws.uniform(0.485, 0.495) * std::numbers::pi;
    for (int row = 0; row < LetterPlan::kRows; ++row)
        for (int column = 0; column < LetterPlan::kColumns; ++column) {
            const double longitude = ((column + 0.5) / LetterPlan::kColumns - 0.5) * width;
            const double latitude = (0.5 - (row + 0.5) / LetterPlan::kRows) * height;
            plan.directions.emplace_back(std::sin(longitude) * std::cos(latitude),
                                         std::sin(latitude),
                                         -std::cos(longitude) * std::cos(latitude));
        }
    const Ball ball{{0.0, 0.0, 3.5}, 0.7};
    plan.flat =
        questionnaire.add(ball, flatMap(kLetterMapWidth, kLetterMapHeight), plan.directions);
    plan.question = questionnaire.add(ball, letterMap(), plan.directions);
    return plan;
}

bool LetterReading::good() const {
    return agrees(h) && agrees(l);
}

std::string look(const LetterCount& count, bool lowered) {
    const std::string right = lowered ? "lowered" : "raised";
    const std::string opposite = lowered ? "raised" : "lowered";
    const EdgeCount& u = count.alongU;
    const EdgeCount& v = count.alongV;
    if (u.crossed() == 0 || v.crossed() == 0) return "unclear";
    if (u.mostlyRight() && v.mostlyRight()) return right;
    if (u.mostlyOpposite() && v.mostlyOpposite()) return opposite;
    const bool half =
        (u.mostlyRight() && v.mostlyOpposite()) || (u.mostlyOpposite() && v.mostlyRight());
    return half ? "half" : "unclear";
}

LetterReading readLetters(const LetterPlan& plan, const Answers& answers,
                          const Parametrisation& parametrisation, const Response& response) {
    return countEdges(recover(plan, answers, parametrisation, response));
}

std::vector<Raster> drawRelief(const LetterPlan& plan, const Answers& answers,
                               const Parametrisation& parametrisation, const Response& response) {
    const CellGrid grid = recover(plan, answers, parametrisation, response);
    std::vector<double> heights;
    heights.reserve(grid.size());
    for (const Cell& cell : grid)
        heights.push_back(cell.height);
    return {raster("expected relief, where your u and v lay the map: H raised, L lowered", heights),
            raster("relief that your normals show", integrate(differencesOf(grid)))};
}

}  // namespace ticker::tasks::bump
