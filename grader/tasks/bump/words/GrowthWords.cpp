#include <grader/tasks/bump/words/GrowthWords.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace ticker::tasks::bump {
namespace {

// If the direction is right, or inverted, at every longitude, only a factor can change.
bool onlyStrengthChanges(const Response& response) {
    const auto keepsDirection = [](const AxisResponse& axis) {
        return axis.bandsThatTurn == 0 &&
               (axis.sense == Sense::right || axis.sense == Sense::inverted);
    };
    return keepsDirection(response.u) && keepsDirection(response.v);
}

Words strengthWords(const Response& response) {
    return {fmt::format("The normal tilts along the right lines, but not as far everywhere: the "
                        "same slope tilts it {:.1f} times as far at one longitude as at another.",
                        std::max(response.u.strengthRatio, response.v.strengthRatio)),
            "Leave Pu and Pv as they are. Bu and Bv, or the terms of Equation (1), are multiplied "
            "or divided by something that changes round the sphere: the distance to the camera "
            "(position.magnitude()), a coordinate of the position or of the normal, an angle. "
            "Take that factor out: the slope is a difference of texels, and nothing else scales "
            "it.",
            "Option 1: What to do, steps 3 and 4"};
}

/// The edges that are lost: "that fall along u and v".
std::string lostEdges(const StepBalance& balance) {
    const auto lost = [](double along) { return along > 0.0 ? "that fall" : "that rise"; };
    if (balance.goodV()) return fmt::format("{} along u", lost(balance.u));
    if (balance.goodU()) return fmt::format("{} along v", lost(balance.v));
    if (balance.u * balance.v > 0.0) return fmt::format("{} along u and v", lost(balance.u));
    return fmt::format("{} along u and those {} along v", lost(balance.u), lost(balance.v));
}

/// How far a slope tilts the normal at some height of the map, divided by how far it does where the
/// map is dark.
struct Grey {
    double tilt;
    const char* name;

    [[nodiscard]] bool operator<(const Grey& other) const { return tilt < other.tilt; }
};

}  // namespace

Words longitudeWords(const Examination& examination) {
    if (onlyStrengthChanges(*examination.ramps().response))
        return strengthWords(*examination.ramps().response);
    const double turn = examination.ramps().response->tangentTurn;
    Words words;
    words.message =
        turn == 0.0 ? "The same slope tilts the normal differently at different longitudes: the "
                      "tilt should turn with the point round the sphere."
                    : fmt::format(
                          "The normal tilts as it should at a longitude that is {:.0f} "
                          "degrees away: the tangents belong to another parametrisation "
                          "than the place where the map is looked up.",
                          std::abs(turn));
    words.hint =
        "Pu and Pv must come from the same angles, with the same axis and the same origin, as the "
        "(u, v) that you look up: write the point with your own longitude and polar angle, and "
        "differentiate that. They have no abs in them, and no fixed vector.";
    words.section = "Option 1: What to do, step 2";
    return words;
}

Words smallSlopesWords() {
    return {"Steps of the map tilt the normal, but even slopes tilt nothing.",
            "Heights are fractions from 0 to 5: look for an int that cuts a difference off, for a "
            "threshold, for a step that reads the same texel twice, or for a sum in which an even "
            "slope cancels, such as right + left - 2 times this texel. Bu is one difference: the "
            "next texel minus this one.",
            "Option 1: What to do, step 3"};
}

Words growthWords(const Examination& examination) {
    // A tilt is measured against the part along n: past the horizon that part is negative.
    const Proportion& proportion = examination.proportion;
    if (examination.ladder.growsWithSlope && proportion.growth < 0.0 &&
        !proportion.staysAboveHorizon())
        return horizonWords(proportion);
    const std::string seen =
        examination.ladder.growsWithSlope
            ? fmt::format(
                  "Slopes that are {} times as steep tilt the normal only {:.2g} times as "
                  "far (median): gentle bumps look as steep as strong ones.",
                  ProportionPlan::kTimes, proportion.growth)
            : "A slope that is 50 times as steep tilts the normal hardly more.";
    return {seen,
            "Bu and Bv are differences of heights as they are: do not normalise them, do not cut "
            "them off (clamp, min, max), and put no tanh or root over them. Only the sum of "
            "Equation (1) is normalised.",
            "Option 1: Theory"};
}

Words heightsBentWords(const Proportion& proportion) {
    const auto [least, most] = std::minmax<Grey>({{1.0, "dark"},
                                                  {proportion.middleOverDark, "grey"},
                                                  {proportion.brightOverDark, "bright"}});
    const double times = most.tilt / least.tilt;
    return {fmt::format("The same slope tilts the normal {} times as much where the map is {} as "
                        "where it is {}.",
                        times < 100.0 ? fmt::format("{:.2g}", times) : "over 100", most.name,
                        least.name),
            "Take heights as they are, heightMap().at(column, row): no power, root, logarithm or "
            "product of heights, and nothing that depends on how bright a texel is. Bu and Bv are "
            "differences of two heights.",
            "Option 1: What to do, step 3"};
}

Words horizonWords(const Proportion& proportion) {
    return {
        fmt::format("Where the map is steep the normal leans 90 degrees or more, at {} of the "
                    "points of a rough map: the tilt grows faster than the slope, past the horizon "
                    "and into the sphere.",
                    percent(proportion.pastHorizon)),
        "A slope is no angle: do not turn the normal by it, and do not add it to the longitude or "
        "the polar angle. Add Bu and Bv times tangents to n and return the normalised sum, "
        "Equation (1), itself: do not reflect n or the sum in anything, as 2 (n.m) m - n doubles "
        "the angle. Or turn the normal by std::atan(slope).",
        "Option 1: Theory"};
}

Words lostStepsWords(const StepBalance& balance) {
    return {fmt::format("Edges of the map {} leave hardly any slope. On random texels, where rises "
                        "and falls are alike, rising slopes make up {} of the tilts along u and {} "
                        "of those along v (right code: about 50 %).",
                        lostEdges(balance), percent(0.5 + 0.5 * balance.u),
                        percent(0.5 + 0.5 * balance.v)),
            "Bu and Bv are one difference each, with its sign: the next texel minus this one. "
            "std::max of the differences to both sides takes the rise beside every fall, and "
            "std::min the fall beside every rise. If both sides should count, take their mean: "
            "half of the next texel minus the one before.",
            "Option 1: What to do, step 3"};
}

Words untiltedWords(const Untilted& untilted) {
    constexpr std::array<const char*, kWhereabouts> kPlaces{
        "within six degrees of the poles",
        "where the eye sees the sphere nearly edge-on",
        "on a sphere that is far away",
        "on a small sphere (radius 0.05)",
        "at black texels (height 0)",
        "in a row or a column of a map of 16 x 5 texels",
        "in a row or a column of a map of 5 x 16 texels",
        "where both slopes are as large (edges at 45 degrees)",
        "where texels are equal in pairs (0 and 1, 2 and 3)",
        "where texels are equal in pairs (1 and 2, 3 and 4)"};
    std::size_t place = 0;
    while (place + 1 < kWhereabouts && untilted.good(static_cast<Whereabouts>(place)))
        ++place;
    return {
        fmt::format("Elsewhere a slope tilts the normal; {} the normal is the smooth one at {} "
                    "of the points of a rough map.",
                    kPlaces.at(place), percent(untilted.shares.at(place))),
        "Take out the condition that returns the smooth normal: only the slopes decide how far "
        "the normal tilts, not the place on the sphere or the map, its size or distance, the eye "
        "or the height itself. Where both slopes are 0 the sum of Equation (1) is n by itself; at "
        "the "
        "exact pole alone any unit normal will do.",
        "Option 1: What to do, step 4"};
}

Words normalMissingWords() {
    return {
        "Wherever the map slopes at all, the normal lies flat in the surface: however gentle "
        "the slope is, the normal turns by 90 degrees.",
        "n is missing from the sum, or hardly counts in it: return n - Bu Pu - Bv Pv, "
        "normalised, Equation (1), with a unit vector n and slopes that no large factor "
        "multiplies.",
        "Option 1: Theory; What to do, step 4"};
}

}  // namespace ticker::tasks::bump
