#include <grader/tasks/bump/places/Untilted.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks::bump {
namespace {

using probe::HeightMapDescription;

constexpr int kPoints = 300;
constexpr int kAxes = 3;
constexpr int kManyPoints = 2000;
constexpr int kFew = 5;    // rows of one map, columns of the other: so few that one left out shows
constexpr int kMore = 16;  // columns of the one, rows of the other

HeightMapDescription rough(Draws& draws) {
    const int width = draws.integer(280, 320);
    return noiseMap(draws, width, draws.integer(140, 170));
}

HeightMapDescription partlyBlack(Draws& draws) {
    HeightMapDescription map = rough(draws);
    for (std::uint8_t& byte : map.bytes)
        byte = draws.integer(0, 2) == 0 ? 0 : static_cast<std::uint8_t>(draws.integer(30, 60));
    return map;
}

/// A map of random bytes in which no two neighbours of a row or a column are nearly equal.
HeightMapDescription coarse(Draws& draws, int width, int height) {
    constexpr int kLeastStep = 12;
    HeightMapDescription map = noiseMap(draws, width, height);
    const auto at = [&](int column, int row) -> std::uint8_t& {
        return map.bytes[static_cast<std::size_t>(row % height * width + column % width)];
    };
    const auto isUnlike = [&](int column, int row) {
        const std::array<int, 4> neighbours{at(column + width - 1, row), at(column + 1, row),
                                            at(column, row + height - 1), at(column, row + 1)};
        return std::ranges::all_of(neighbours, [&](int neighbour) {
            return std::abs(neighbour - at(column, row)) >= kLeastStep;
        });
    };
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            while (!isUnlike(column, row))
                at(column, row) = static_cast<std::uint8_t>(draws.integer(0, 255));
    return map;
}

/// Rises and falls along one diagonal in the left half, along the other in the right one. The bytes
/// are chosen so that equal steps differ in height by exactly the same, to the last bit.
HeightMapDescription diagonal(Draws& draws) {
    constexpr int kPeriod = 14;
    constexpr int kStep = 16;
    constexpr int kLeast = 3;
    HeightMapDescription map = noiseMap(draws, 20 * kPeriod, 10 * kPeriod);
    for (int row = 0; row < map.height; ++row)
        for (int column = 0; column < map.width; ++column) {
            const int along = column < map.width / 2 ? column - row : column + row;
            const int phase = (along % kPeriod + kPeriod) % kPeriod;
            const int height = kLeast + kStep * std::min(phase, kPeriod - phase);
            map.bytes[static_cast<std::size_t>(row * map.width + column)] =
                static_cast<std::uint8_t>(height);
        }
    return map;
}

/// Columns are equal in pairs in the left half, rows in the right one.
/// @param first  0: texels 0 and 1 are equal; 1: texels 1 and 2.
HeightMapDescription inPairs(Draws& draws, int first) {
    HeightMapDescription map = noiseMap(draws, 120, 120);
    const auto heightOf = [first](int at) {
        const int pair = (at + first) / 2;
        return static_cast<std::uint8_t>(pair % 2 == 0 ? 60 : 100);
    };
    for (int row = 0; row < map.height; ++row)
        for (int column = 0; column < map.width; ++column)
            map.bytes[static_cast<std::size_t>(row * map.width + column)] =
                heightOf(column < map.width / 2 ? column : row);
    return map;
}

std::vector<Vector3> nearPoles(Draws& draws) {
    std::vector<Vector3> directions;
    for (int i = 0; i < kPoints; ++i) {
        const double turn = draws.uniform(0.0, 2.0 * kPi);
        const double angle = draws.uniform(2.3, 5.5) * kPi / 180.0;
        const double across = std::sin(angle) * std::cos(turn);
        const double beside = std::sin(angle) * std::sin(turn);
        const double along = (i / kAxes) % 2 == 0 ? std::cos(angle) : -std::cos(angle);
        const std::array<Vector3, kAxes> axes{
            {{across, along, beside}, {across, beside, along}, {along, across, beside}}};
        directions.push_back(axes.at(static_cast<std::size_t>(i % kAxes)));
    }
    return directions;
}

std::vector<Vector3> atRim(Draws& draws, const Ball& ball) {
    constexpr double kLeast = 0.02;  // of N.V
    constexpr double kMost = 0.2;
    std::vector<Vector3> directions;
    while (directions.size() < static_cast<std::size_t>(kPoints))
        for (const Vector3& direction : draws.directions(kPoints)) {
            const double facing = direction.dot((-ball.at(direction)).normalised());
            if (facing > kLeast && facing < kMost) directions.push_back(direction);
        }
    return directions;
}

/// Share of the tilts that are so small that they count as none.
/// @param every  Counts only every n-th tilt, from `first` on.
double smoothShare(const std::vector<Vector3>& tilts, std::size_t first, std::size_t every) {
    double smooth = 0.0;
    double all = 0.0;
    for (std::size_t i = first; i < tilts.size(); i += every) {
        all += 1.0;
        if (tilts[i].magnitude() < kLeastTilt) smooth += 1.0;
    }
    return smooth / all;
}

}  // namespace

UntiltedPlan planUntilted(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    const Ball farAway{{draws.uniform(-9.0, 9.0), draws.uniform(-9.0, 9.0), 180.0}, 45.0};
    const Ball small{{draws.uniform(-0.9, 0.9), draws.uniform(-0.9, 0.9), 2.0}, 0.05};
    UntiltedPlan plan;
    // The arguments are in a braced list, which is evaluated from left to right, so that the draws
    // have a fixed order.
    struct Asked {
        const Ball& on;
        std::vector<Vector3> directions;
        HeightMapDescription map;
    };
    const auto ask = [&](Whereabouts where, Asked asked) {
        plan.pairs.at(static_cast<std::size_t>(where)) =
            questionnaire.addPair(asked.on, std::move(asked.map), asked.directions);
    };
    ask(Whereabouts::nearPoles, {ball, nearPoles(draws), rough(draws)});
    ask(Whereabouts::atRim, {ball, atRim(draws, ball), rough(draws)});
    ask(Whereabouts::farAway, {farAway, draws.directions(kPoints), rough(draws)});
    ask(Whereabouts::smallSphere, {small, draws.directions(kPoints), rough(draws)});
    ask(Whereabouts::onBlack, {ball, draws.directions(2 * kPoints), partlyBlack(draws)});
    ask(Whereabouts::fewRows, {ball, draws.directions(kManyPoints), coarse(draws, kMore, kFew)});
    ask(Whereabouts::fewColumns, {ball, draws.directions(kManyPoints), coarse(draws, kFew, kMore)});
    ask(Whereabouts::evenSteps, {ball, draws.directions(3 * kPoints), inPairs(draws, 0)});
    ask(Whereabouts::oddSteps, {ball, draws.directions(3 * kPoints), inPairs(draws, 1)});
    ask(Whereabouts::onDiagonals, {ball, draws.directions(3 * kPoints), diagonal(draws)});
    return plan;
}

bool Untilted::good(Whereabouts where) const {
    constexpr double kMost = 0.22;
    constexpr double kMostOfFew = 0.06;
    constexpr double kMostBetweenPairs = 0.25;
    const bool isOfFew = where == Whereabouts::fewRows || where == Whereabouts::fewColumns;
    if (where == Whereabouts::evenSteps || where == Whereabouts::oddSteps) {
        const double even = shares.at(static_cast<std::size_t>(Whereabouts::evenSteps));
        const double odd = shares.at(static_cast<std::size_t>(Whereabouts::oddSteps));
        const double more = where == Whereabouts::evenSteps ? even - odd : odd - even;
        return more < kMostBetweenPairs;
    }
    return shares.at(static_cast<std::size_t>(where)) < (isOfFew ? kMostOfFew : kMost);
}

bool Untilted::good() const {
    for (std::size_t i = 0; i < kWhereabouts; ++i)
        if (!good(static_cast<Whereabouts>(i))) return false;
    return true;
}

Untilted readUntilted(const UntiltedPlan& plan, const Answers& answers) {
    Untilted untilted;
    for (std::size_t i = 0; i < kWhereabouts; ++i) {
        const LevelPair& pair = plan.pairs.at(i);
        const std::vector<Vector3> tilts = answers.tiltsBeyond(pair.flat, pair.map);
        // The map's poles lie on one of the axes, and it is not known on which.
        const bool isAtPoles = static_cast<Whereabouts>(i) == Whereabouts::nearPoles;
        const std::size_t groups = isAtPoles ? kAxes : 1;
        for (std::size_t group = 0; group < groups; ++group)
            untilted.shares.at(i) =
                std::max(untilted.shares.at(i), smoothShare(tilts, group, groups));
    }
    return untilted;
}

}  // namespace ticker::tasks::bump
