#include <grader/decision/bump/WrongWords.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace ticker::decision::bump {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Message, hint and section of one finding.

Words inwardWords(const Offence& inward) {
    return {fmt::format("The normal points into the sphere at {}; the first is {}.",
                        pointsOf(inward), firstAt(inward)),
            "The smooth normal is position minus centre, not the other way round; with a cross "
            "product of two tangents, mind their order.",
            "1, Implementation, step 1"};
}

Words flatTiltedWords(double tilt) {
    return {
        fmt::format("On a map without any slope the normal should be the smooth sphere's, but "
                    "it is tilted by {:.0f} degrees (median).",
                    std::atan(tilt) * kDegrees),
        "The tilt must come from differences of heights, not from heights, and must be added to "
        "the unit normal, (position - centre) / radius.",
        "1, Implementation, steps 1 and 3"};
}

Words smallSlopesWords() {
    return {"Steps of the map tilt the normal, but even slopes tilt nothing.",
            "Heights are fractions from 0 to 5: look for an int that cuts a difference off, or for "
            "a step that reads the same texel twice.",
            "1, Implementation, step 3"};
}

Words growthWords() {
    return {
        "A slope that is 50 times as steep tilts the normal hardly more: a bigger bump should "
        "give a larger coefficient.",
        "Do not normalise the slopes, and do not cut them off: only the sum of Equation (1) is "
        "normalised.",
        "1, Theory"};
}

Words steepWords() {
    return {"Steep slopes tilt the normal in another direction than gentle ones.",
            "Bu and Bv should be in proportion to the differences of the heights.", "1, Theory"};
}

/// The beginning of a hint where the code does well as long as every map has one size.
std::string rememberedSize(const std::optional<Hints>& hints) {
    if (!hints || hints->square.kind != RampKind::right) return {};
    return "As long as every map has the same size, the tilt is right: look for a size that is "
           "remembered (a static variable) or written in as a number. ";
}

Words strangeLandingWords(const Examination& examination, const std::optional<Hints>& hints) {
    std::string hint =
        "Check u and v: with the smooth unit normal n, the polar angle is acos(n.y) and the "
        "longitude an atan2 of n.x and n.z; u is the longitude over 2 pi, v the polar angle over "
        "pi.";
    if (const std::string remembered = rememberedSize(hints); !remembered.empty())
        hint = remembered + hint;
    else if (hints && hints->unitSphere.response)
        hint =
            "On a sphere of radius 1 around the origin the map lies where it should: somewhere "
            "the centre is not subtracted, or the radius not divided out. " +
            hint;
    else if (hints && hints->sceneSphere.response)
        hint =
            "On the exercise's own sphere the map lies where it should: use centre() and "
            "radius() (or Sphere::getNormalAt) instead of numbers. " +
            hint;
    std::string message =
        "The map does not lie on the sphere as spherical polar coordinates put it";
    if (examination.ramps.fit)
        message += fmt::format(
            ": {} of the points read a texel that lies more than a twentieth of "
            "the map away from where it should be",
            percent(examination.ramps.fit->strayShare));
    return {message + ".", hint, "1, Implementation, step 1"};
}

Words signLostWords(const std::optional<Hints>& hints) {
    return {"A falling slope does not tilt the normal the other way than a rising one does.",
            rememberedSize(hints) +
                "Look for an abs, a max or an unsigned type in the differences, and check that the "
                "column and the row change with the point.",
            "1, Implementation, step 3"};
}

Words ignoredWords(const std::string& axis, const std::string& what) {
    return {fmt::format("A slope along {} alone tilts nothing: the normal does not change where "
                        "only {} differ.",
                        axis, what),
            fmt::format("Check that B{0} is a difference of neighbouring {1}, and that the term "
                        "with B{0} is added.",
                        axis, what),
            "1, Implementation, step 3"};
}

std::string directionInWords(const AxisResponse& axis) {
    return fmt::format("{} right, {} inverted, {} along the other axis, {} not at all",
                       percent(axis.shares.right), percent(axis.shares.inverted),
                       percent(axis.shares.across), percent(axis.shares.dead));
}

/// ", everywhere 30 degrees off", where every band of an axis agrees on that.
std::string commonTurn(const AxisResponse& axis) {
    constexpr double kAgree = 10.0;
    const auto [least, most] =
        std::minmax_element(axis.bandDirection.begin(), axis.bandDirection.end());
    const double middle = std::abs(0.5 * (*least + *most));
    if (*most - *least > kAgree || middle < kAgree) return {};
    return fmt::format(", everywhere {:.0f} degrees off", middle);
}

Words directionWords(const Response& response) {
    const AxisResponse& farthest =
        std::abs(response.u.worstDirection) > std::abs(response.v.worstDirection) ? response.u
                                                                                  : response.v;
    return {
        fmt::format("The tilt fits no reading of Equation (1). A slope along u tilts the normal: "
                    "{}{}. A slope along v: {}{}.",
                    directionInWords(response.u), commonTurn(response.u),
                    directionInWords(response.v), commonTurn(response.v)),
        fmt::format("The farthest off is {}. Work out Pu, Pv, Bu and Bv there by hand and "
                    "compare.",
                    placeInWords(farthest.worst)),
        "1, Implementation, steps 2 and 3"};
}

Words patchyWords(const Response& response) {
    const AxisResponse& axis =
        response.u.shares.dead > response.v.shares.dead ? response.u : response.v;
    return {
        fmt::format("On an even slope many points are not tilted at all: {} of them along u, {} "
                    "along v. Elsewhere the direction is right.",
                    percent(response.u.shares.dead), percent(response.v.shares.dead)),
        fmt::format("One of them lies {}. A step in u or v that is smaller than a texel often "
                    "reads the same texel twice; a tangent may have no length there.",
                    placeInWords(axis.deadAt)),
        "1, Implementation, steps 2 and 3"};
}

Words slopesWords(const SlopeAgreement& slopes) {
    return {fmt::format("On even ramps the tilt is right, but on pictures it is not: on a smooth "
                        "random map {} of the tilt along u and {} of that along v lean against the "
                        "slope of the map (right code: all but a few percent).",
                        percent(0.5 + 0.5 * slopes.fieldU), percent(0.5 + 0.5 * slopes.fieldV)),
            "Check that Bu compares two texels of the point's own row, and Bv two of its own "
            "column.",
            "1, Implementation, step 3"};
}

Words lettersWords(const LetterReading& letters) {
    return {
        fmt::format("On ramps the tilt is right, but on the letter map the H looks {} and the L "
                    "looks {}: expected are raised H and lowered L.",
                    look(letters.h, false), look(letters.l, true)),
        "Look for anything that treats steep slopes unlike gentle ones, or falling ones unlike "
        "rising ones.",
        "1, Testing"};
}

}  // namespace

Words wrongWords(WrongReason reason, const Examination& examination,
                 const std::optional<Hints>& hints) {
    switch (reason) {
        case WrongReason::inward:
            return inwardWords(examination.conduct.inward);
        case WrongReason::flatTilted:
            return flatTiltedWords(examination.flatTilt);
        case WrongReason::slopeUIgnored:
            return ignoredWords("u", "columns");
        case WrongReason::slopeVIgnored:
            return ignoredWords("v", "rows");
        case WrongReason::signLost:
            return signLostWords(hints);
        case WrongReason::strangeLanding:
            return strangeLandingWords(examination, hints);
        case WrongReason::smallSlopesLost:
            return smallSlopesWords();
        case WrongReason::patchy:
            return patchyWords(*examination.ramps.response);
        case WrongReason::strangeDirection:
            return directionWords(*examination.ramps.response);
        case WrongReason::doesNotGrow:
            return growthWords();
        case WrongReason::steepDiffers:
            return steepWords();
        case WrongReason::slopesDiffer:
            return slopesWords(*examination.slopes);
        case WrongReason::lettersDiffer:
            return lettersWords(*examination.letters);
    }
    return {};
}

}  // namespace ticker::decision::bump
