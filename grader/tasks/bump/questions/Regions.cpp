#include <grader/tasks/bump/questions/Regions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace ticker::tasks::bump {
namespace {

using probe::HeightMapDescription;

constexpr std::size_t kZones = 6;  // of equal area, from pole to pole
constexpr std::size_t kSlices = 8;

constexpr double kFall = 2.0 * kByte;  // for each texel

/// Falls, and restarts after 64 texels: two such waves together take 252 bytes.
std::vector<double> teeth(int count) {
    constexpr int kTooth = 64;
    std::vector<double> heights;
    heights.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        heights.push_back(kFall * (kTooth - 1 - i % kTooth));
    return heights;
}

/// A point and its tilt along one axis of the map, positive if it has the ramps' sign.
struct Lean {
    double u = 0.0;
    double v = 0.0;
    double along = 0.0;
    double usual = 0.0;  ///< tilt that the ramps show for this slope at this polar angle

    [[nodiscard]] std::size_t region() const {
        const double height = 0.5 - 0.5 * std::cos(std::numbers::pi * v);
        const auto zone = std::min(kZones - 1, static_cast<std::size_t>(height * kZones));
        const auto slice = std::min(kSlices - 1, static_cast<std::size_t>(u * kSlices));
        return zone * kSlices + slice;
    }
};

struct Leans {
    std::vector<Lean> alongU;
    std::vector<Lean> alongV;
};

/// The tilts along both axes. Their signs are turned, because the map falls where the ramps rise.
Leans readLeans(const RegionPlan& plan, const Answers& answers, const RampJudgement& ramps) {
    const Parametrisation& parametrisation = ramps.fit->parametrisation;
    const AxisResponse& onU = ramps.response->u;
    const AxisResponse& onV = ramps.response->v;
    const double timesU = kFall / ramps.shape.slope(ramps.shape.columns);
    const double timesV = kFall / ramps.shape.slope(ramps.shape.rows);
    const std::vector<Vector3> tilts = answers.tilts(plan.question);
    Leans leans;
    for (std::size_t i = 0; i < tilts.size(); ++i) {
        const Vector3& n = plan.directions[i];
        const double u = parametrisation.u(n);
        const double v = parametrisation.v(n);
        if (!isFinite(tilts[i]) || !isOrdinary(parametrisation, n)) continue;
        leans.alongU.push_back({u, v, onU.sign() * tilts[i].dot(parametrisation.alongU(n)),
                                timesU * strengthAt(onU, v)});
        leans.alongV.push_back({u, v, onV.sign() * tilts[i].dot(parametrisation.alongV(n)),
                                timesV * strengthAt(onV, v)});
    }
    return leans;
}

/// Counts points and wrong points over one coordinate of the map.
class Bins {
public:
    void add(double coordinate, bool strays) {
        const auto bin = std::min(kBins - 1, static_cast<std::size_t>(coordinate * kBins));
        asked_[bin] += 1.0;
        if (strays) strays_[bin] += 1.0;
    }

    /// The longest run of bins in which most points are wrong; empty if these are not clearly a
    /// part of the map. Bins of a few points do not count.
    [[nodiscard]] std::optional<TexelRange> range(int count) const {
        constexpr double kFew = 4.0;
        Run longest;
        Run run;
        bool everywhere = true;
        for (std::size_t i = 0; i < kBins; ++i) {
            if (asked_[i] < kFew) continue;
            if (strays_[i] <= 0.5 * asked_[i]) {
                everywhere = false;
                run = {};
                continue;
            }
            if (run.asked == 0.0) run.first = i;
            run.last = i;
            run.asked += asked_[i];
            run.strays += strays_[i];
            if (run.asked > longest.asked) longest = run;
        }
        constexpr double kClearly = 0.75;
        if (everywhere || !(longest.strays > kClearly * longest.asked)) return std::nullopt;
        const auto texel = [count](std::size_t bin) {
            return static_cast<int>(bin * static_cast<std::size_t>(count) / kBins);
        };
        return TexelRange{texel(longest.first), texel(longest.last + 1) - 1};
    }

private:
    struct Run {
        std::size_t first = 0;
        std::size_t last = 0;
        double asked = 0.0;
        double strays = 0.0;
    };

    static constexpr std::size_t kBins = 64;
    std::array<double, kBins> asked_{};
    std::array<double, kBins> strays_{};
};

RegionShares shareOf(const std::vector<Lean>& leans, const HeightMapDescription& map) {
    // The displaced surface tilts by a third of the proportional value where it is high. A tilt
    // that depends on the map's size may be weaker by the ratio of two sides.
    constexpr double kSome = 0.02;
    constexpr double kFewest = 15.0;
    std::array<double, kZones * kSlices> asked{};
    std::array<double, kZones * kSlices> right{};
    Bins overU;
    Bins overV;
    double strays = 0.0;
    for (const Lean& lean : leans) {
        const bool isRight = lean.along > kSome * lean.usual;
        asked[lean.region()] += 1.0;
        (isRight ? right[lean.region()] : strays) += 1.0;
        overU.add(lean.u, !isRight);
        overV.add(lean.v, !isRight);
    }
    RegionShares shares;
    shares.asOnRamps = 1.0 - strays / std::max(1.0, static_cast<double>(leans.size()));
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (asked[i] >= kFewest) {
            shares.worst = std::min(shares.worst, right[i] / asked[i]);
            shares.best = std::max(shares.best, right[i] / asked[i]);
        }
    shares.columns = overU.range(map.width);
    shares.rows = overV.range(map.height);
    return shares;
}

}  // namespace

RegionPlan planRegions(Questionnaire& questionnaire, Draws& draws, const Ball& ball,
                       std::vector<Vector3> directions) {
    constexpr int kMore = 1000;
    RegionPlan plan;
    plan.directions = std::move(directions);
    for (const Vector3& direction : draws.directions(kMore))
        plan.directions.push_back(direction);
    const int width = draws.integer(860, 900);
    const int height = draws.integer(640, 680);
    plan.question =
        questionnaire.add(ball, {width, height, {}, teeth(width), teeth(height)}, plan.directions);
    return plan;
}

bool RegionShares::good() const {
    // Teeth end at 2 percent of the points, or at 20 for differences over a hundredth of the map.
    // Then more than 24 of 40 points of a region are wrong with a chance below one in a million.
    constexpr double kMost = 0.75;
    constexpr double kWorst = 0.4;
    return asOnRamps >= kMost && worst >= kWorst;
}

RegionAgreement readRegions(const RegionPlan& plan, const Answers& answers,
                            const RampJudgement& ramps) {
    const HeightMapDescription& map = answers.asked().question(plan.question).map;
    const Leans leans = readLeans(plan, answers, ramps);
    return {shareOf(leans.alongU, map), shareOf(leans.alongV, map), map.width, map.height};
}

bool areTheSame(const Answers& answers, std::size_t question, std::size_t other) {
    constexpr double kRounding = 1e-12;
    constexpr double kSomeTilt = 1e-6;
    constexpr double kAlmostAll = 0.9;
    const std::vector<Vector3> one = answers.tilts(question);
    const std::vector<Vector3> two = answers.tilts(other);
    const std::size_t count = std::min(one.size(), two.size());
    double same = 0.0;
    for (std::size_t i = 0; i < count; ++i)
        if ((one[i] - two[i]).magnitude() <= kRounding && one[i].magnitude() > kSomeTilt)
            same += 1.0;
    return same >= kAlmostAll * static_cast<double>(count);
}

}  // namespace ticker::tasks::bump
