#include <grader/tasks/bump/places/FewTexels.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks::bump {
namespace {

constexpr int kManyTexels = 64;

/// High at both ends and low in the middle, round the height of a flat map.
std::vector<double> singleWave(int count) {
    constexpr double kMiddle = 2.5;
    constexpr double kLift = 0.3;
    std::vector<double> heights;
    for (int i = 0; i < count; ++i)
        heights.push_back(kMiddle + kLift * std::cos(kTurn * (i + 0.5) / count));
    return heights;
}

/// Height of a flat map, but for the last texel and one in the middle, which are higher.
std::vector<double> twoRidges(int count) {
    constexpr double kLevel = 2.5;
    constexpr double kHigher = 0.3;
    std::vector<double> heights = raytracer::questions::level(count, kLevel);
    heights.at(static_cast<std::size_t>(count / 2)) += kHigher;
    heights.back() += kHigher;
    return heights;
}

/// Shares of right tilts: in the second texel or the last but one, and inside the map.
class EdgeShares {
public:
    explicit EdgeShares(int count) : count_(count) {}

    /// @param coordinate  Of the map, 0 to 1.
    /// @param along       The tilt along growing coordinates.
    void add(double coordinate, double along) {
        // The half of the texel in which rounding to the nearest texel does not lead to the map's
        // edge either.
        constexpr double kFrom = 1.55;
        constexpr double kTo = 1.95;
        const double fromStart = coordinate * count_;
        const double fromEnd = count_ - fromStart;
        if (fromStart > kFrom && fromStart < kTo) start_.add(along);
        if (fromEnd > kFrom && fromEnd < kTo) end_.add(-along);
        constexpr double kInside = 2.0;
        if (fromStart > kInside && fromStart < 0.5 * count_ - kInside) inside_.add(along);
        if (fromEnd > kInside && fromEnd < 0.5 * count_ - kInside) inside_.add(-along);
    }
    [[nodiscard]] double least() const { return std::min(start_.share(), end_.share()); }
    [[nodiscard]] double inside() const { return inside_.share(); }

private:
    struct Count {
        double asked = 0.0;
        double right = 0.0;

        void add(double downhill) {
            if (!std::isfinite(downhill)) return;
            asked += 1.0;
            if (downhill > kLeastTilt) right += 1.0;
        }
        // Of 3000 points 45 lie in either column and 70 in either row, on average.
        [[nodiscard]] double share() const {
            constexpr double kFewest = 20.0;
            return asked < kFewest ? 1.0 : right / asked;
        }
    };

    int count_;
    Count start_;
    Count end_;
    Count inside_;
};

/// Compares what the ridge at the map's end does to the texels before it with what the ridge in the
/// middle does.
class RidgeShares {
public:
    explicit RidgeShares(int count) : count_(count) {}

    /// @param coordinate  Of the map, 0 to 1.
    /// @param along       The tilt along growing coordinates.
    void add(double coordinate, double along) {
        const double at = coordinate * count_;
        if (isBefore(at, count_)) end_.add(along);
        // NOLINTNEXTLINE(bugprone-integer-division): the ridge in the middle is a whole texel
        if (isBefore(at, count_ / 2 + 1)) middle_.add(along);
    }
    /// 1 if nothing tilts before the ridge in the middle, as with differences to the texel before,
    /// or if the ridge at the end does not show on its own texel.
    [[nodiscard]] double beforeLast() const {
        // A share of the points of three texels. The last row, next to the pole, has only a ninth
        // of the points of the last three.
        constexpr double kShown = 0.06;
        if (middle_.rising() < kShown || end_.falling() < kShown) return 1.0;
        return end_.rising() / middle_.rising();
    }

private:
    /// The ridge's own texel and the two before it: a coordinate that is rounded to the nearest
    /// texel, or that is stretched to the last texel, moves by less.
    [[nodiscard]] static bool isBefore(double at, double end) {
        constexpr double kTexels = 3.0;
        return at < end && at >= end - kTexels;
    }

    struct Count {
        double asked = 0.0;
        double tiltsBack = 0.0;
        double tiltsOn = 0.0;

        void add(double along) {
            if (!std::isfinite(along)) return;
            asked += 1.0;
            if (along < -kLeastTilt) tiltsBack += 1.0;
            if (along > kLeastTilt) tiltsOn += 1.0;
        }
        // Of 3000 points 330 lie in three columns, and 440 in the last three rows, on average.
        [[nodiscard]] double rising() const { return asked > 0.0 ? tiltsBack / asked : 0.0; }
        [[nodiscard]] double falling() const { return asked > 0.0 ? tiltsOn / asked : 0.0; }
    };

    int count_;
    Count middle_;
    Count end_;
};

/// Compares the tilts in the outer halves of the first and the last column with those where the
/// wave is steepest.
class SeamTilts {
public:
    /// @param u  Of the map, 0 to 1.
    void add(double u, double along) {
        constexpr double kHalf = 0.5 / kFewColumns;
        constexpr double kColumn = 1.0 / kFewColumns;
        if (!std::isfinite(along)) return;
        if (u < kHalf) first_.push_back(std::abs(along));
        if (u > 1.0 - kHalf) last_.push_back(std::abs(along));
        // The wave is steepest at 1/4 and 3/4.
        if (std::abs(std::abs(u - 0.5) - 0.25) < kColumn) steepest_.push_back(std::abs(along));
    }
    [[nodiscard]] double most() const {
        const double steep = median(steepest_);
        return std::max(share(first_, steep), share(last_, steep));
    }

private:
    // About 55 of 3000 points lie in either half, on average. The tilt of a difference over three
    // columns that lies two columns aside is half of the steepest one.
    [[nodiscard]] static double share(const std::vector<double>& tilts, double steepest) {
        constexpr std::size_t kFewest = 20;
        constexpr double kNearly = 0.75;
        if (tilts.size() < kFewest || !(steepest > kLeastTilt)) return 0.0;
        const auto steep =
            std::ranges::count_if(tilts, [&](double tilt) { return tilt > kNearly * steepest; });
        return static_cast<double>(steep) / static_cast<double>(tilts.size());
    }

    std::vector<double> first_;
    std::vector<double> last_;
    std::vector<double> steepest_;
};

/// Tilts along u in the first and in the last column, divided by those along v.
class AsideShare {
public:
    /// @param u  Of the map, 0 to 1.
    void add(double u, double alongU, double alongV) {
        constexpr double kEdge = 1.0 / kManyTexels;
        if (!std::isfinite(alongU) || !std::isfinite(alongV)) return;
        if (u < kEdge) first_.add(alongU, alongV);
        if (u > 1.0 - kEdge) last_.add(alongU, alongV);
    }
    [[nodiscard]] double most() const { return std::max(first_.share(), last_.share()); }

private:
    struct Sums {
        double points = 0.0;
        double alongU = 0.0;
        double alongV = 0.0;

        void add(double u, double v) {
            points += 1.0;
            alongU += std::abs(u);
            alongV += std::abs(v);
        }
        // About 40 of 3000 points lie in either column, on average.
        [[nodiscard]] double share() const {
            constexpr double kFewest = 10.0;
            return points < kFewest || alongV <= 0.0 ? 0.0 : alongU / alongV;
        }
    };
    Sums first_;
    Sums last_;
};

}  // namespace

FewTexelPlan planFewTexels(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    constexpr int kPoints = 3000;
    FewTexelPlan plan;
    plan.directions = draws.directions(kPoints);
    const std::vector<double> across = raytracer::questions::level(kManyTexels);
    plan.columns = questionnaire.addPair(
        ball, {kFewColumns, kManyTexels, {}, singleWave(kFewColumns), across}, plan.directions);
    plan.rows = questionnaire.addPair(
        ball, {kManyTexels, kFewRows, {}, across, singleWave(kFewRows)}, plan.directions);
    plan.columnRidges = questionnaire.add(
        ball, {kFewColumns, kManyTexels, {}, twoRidges(kFewColumns), across}, plan.directions);
    plan.rowRidges = questionnaire.add(
        ball, {kManyTexels, kFewRows, {}, across, twoRidges(kFewRows)}, plan.directions);
    return plan;
}

FewTexels readFewTexels(const FewTexelPlan& plan, const Answers& answers,
                        const Parametrisation& parametrisation) {
    constexpr double kFromPole = 0.15;  // nearer, columns are narrow and their chords bend
    const std::vector<Vector3> onColumns = answers.tiltsBeyond(plan.columns.flat, plan.columns.map);
    const std::vector<Vector3> onRows = answers.tiltsBeyond(plan.rows.flat, plan.rows.map);
    const std::vector<Vector3> byColumnRidges =
        answers.tiltsBeyond(plan.columns.flat, plan.columnRidges);
    const std::vector<Vector3> byRowRidges = answers.tiltsBeyond(plan.rows.flat, plan.rowRidges);
    RidgeShares lastColumn(kFewColumns);
    RidgeShares lastRow(kFewRows);
    EdgeShares alongU(kFewColumns);
    EdgeShares alongV(kFewRows);
    AsideShare aside;
    SeamTilts seam;
    for (std::size_t i = 0; i < plan.directions.size(); ++i) {
        const Vector3& n = plan.directions[i];
        const double v = parametrisation.v(n);
        if (std::min(v, 1.0 - v) > kFromPole) {
            alongU.add(parametrisation.u(n), onColumns[i].dot(parametrisation.alongU(n)));
            seam.add(parametrisation.u(n), onColumns[i].dot(parametrisation.alongU(n)));
            lastColumn.add(parametrisation.u(n), byColumnRidges[i].dot(parametrisation.alongU(n)));
            aside.add(parametrisation.u(n), onRows[i].dot(parametrisation.alongU(n)),
                      onRows[i].dot(parametrisation.alongV(n)));
        }
        alongV.add(v, onRows[i].dot(parametrisation.alongV(n)));
        lastRow.add(v, byRowRidges[i].dot(parametrisation.alongV(n)));
    }
    return {.alongU = alongU.least(),
            .alongV = alongV.least(),
            .insideU = alongU.inside(),
            .insideV = alongV.inside(),
            .aside = aside.most(),
            .beforeLastColumn = lastColumn.beforeLast(),
            .beforeLastRow = lastRow.beforeLast(),
            .steepAtSeam = seam.most()};
}

}  // namespace ticker::tasks::bump
