#include <grader/tasks/bump/words/WrongWords.h>

#include <grader/tasks/bump/questions/Numbers.h>
#include <grader/tasks/bump/words/DirectionWords.h>
#include <grader/tasks/bump/words/GrowthWords.h>
#include <grader/tasks/bump/words/ParametrisationWords.h>
#include <grader/tasks/bump/words/PlaceWords.h>
#include <grader/tasks/bump/words/RegionWords.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace ticker::tasks::bump {
namespace {

Words inwardWords(const Examination& examination) {
    const Offence& inward = examination.conduct.inward;
    const char* const ofAll =
        pointsInwards(examination)
            ? " If the smooth normal is right, all terms of the sum have the wrong sign: return n "
              "- Bu Pu - Bv Pv, Equation (1)."
            : "";
    return {fmt::format("The normal points into the sphere at {}; the first is {}.",
                        pointsOf(inward), firstAt(inward)),
            std::string{"The smooth normal is position minus centre, not the other way round; with "
                        "a cross product of two tangents, mind their order. Do not turn the normal "
                        "towards the camera: mirrors see the far side."} +
                ofAll,
            "Option 1: What to do, step 1"};
}

Words flatTiltedWords(double tilt) {
    return {
        fmt::format("On a map without any slope the normal should be the smooth sphere's, but "
                    "it is tilted by {:.0f} degrees (median).",
                    std::atan(tilt) * kDegrees),
        "The tilt must come from differences of heights, not from heights: return n - Bu Pu - Bv "
        "Pv, normalised, Equation (1), with the unit normal n = (position - centre) / radius. A "
        "fixed vector such as (-Bu, Bv, -1) belongs to a flat picture.",
        "Option 1: What to do, steps 1 and 3"};
}

Words roundedNormalWords(double shared) {
    return {fmt::format("On a map without any slope {} of the points have exactly the normal of "
                        "another point: normals are rounded to few values.",
                        percent(shared)),
            "Return the normalised sum of Equation (1) as it is: leave out std::round and int in "
            "everything but the column and the row.",
            "Option 1: What to do, step 4"};
}

Words steepWords(double agreeing) {
    return {
        fmt::format("On a ramp from black to white the normal tilts in another direction than on "
                    "a gentle one, at {} of the points.",
                    percent(1.0 - agreeing)),
        "Bu and Bv should be in proportion to the differences of the heights, whatever the heights "
        "are: look for an abs, or for a special case for dark, bright or steep texels.",
        "Option 1: What to do, step 3"};
}

Words mapIgnoredWords() {
    return {
        "Another bump map on the same sphere gives the very same normals: the map that the sphere "
        "has now is not the one that is used.",
        "Look for what is remembered between calls (a static variable that holds a map, heights, "
        "slopes or normals) and for a tilt that uses no height at all. A scene may have several "
        "bumpy spheres, each with a map of its own: read heightMap() in each call.",
        "Option 1: What to do, step 3"};
}

Words remembersWords() {
    return {
        "The same point of the same map gets another normal where another sphere's map was asked "
        "about just before.",
        "What is kept between calls (a static or thread_local variable with the last texel, "
        "heights, "
        "slopes or normal) must not outlive its map: read heightMap() in each call, or ask whether "
        "it is still the same map.",
        "Option 1: What to do, step 3"};
}

Words orderWords() {
    return {
        "The same point of the same map gets another normal when the points are asked for in "
        "another order.",
        "getNormalAt must know its own point alone, since pixels come in any order: look for a "
        "static or thread_local variable that keeps a height, a texel or a normal of the call "
        "before, and for chance.",
        "Option 1: What to do, step 3"};
}

Words chanceWords(double change) {
    return {fmt::format("The same point of a map without any slope gets another normal each time: "
                        "they differ by {:.0f} degrees (median).",
                        change * kDegrees),
            "Nothing in Equation (1) is random, and nothing of an earlier call may be used.",
            "Option 1: Theory"};
}

Words ignoredWords(const std::string& axis, const std::string& what) {
    return {fmt::format("A slope along {} alone tilts nothing: the normal does not change where "
                        "only {} differ.",
                        axis, what),
            fmt::format("Check that B{0} is a difference of neighbouring {1}, and that the term "
                        "with B{0} is added.",
                        axis, what),
            "Option 1: What to do, step 3"};
}

Words roundedWords(const Fineness& fineness) {
    const char* both = "u and v are";
    const char* one = fineness.goodV() ? "u is" : "v is";
    return {fmt::format("On a large map, {} x {} texels, points that are {} texels apart read the "
                        "same texel, or one that is too far away: {} rounded too coarsely.",
                        FinenessPlan::kColumns, FinenessPlan::kRows, FinenessPlan::kHalf,
                        fineness.goodU() || fineness.goodV() ? one : both),
            "Keep angles, u and v as fractions (double), not as whole degrees or percent, and take "
            "no angle from a table; only the column, u * width(), and the row, v * height(), "
            "become whole numbers.",
            "Option 1: What to do, steps 1 and 3"};
}

Words teethWords(const SlopeAgreement& slopes) {
    return {fmt::format("On a map of sawteeth the tilt is not what it is on even ramps: {} of the "
                        "points along u and {} along v keep to it (right code: more than 90 %).",
                        percent(slopes.sawtoothU), percent(slopes.sawtoothV)),
            "Check that Bu and Bv compare texels that are next to each other, and that nothing "
            "depends on how bright the texels are: no abs, and no type that is too small for a "
            "height (int8_t, char, uint8_t).",
            "Option 1: What to do, step 3"};
}

Words slopesWords(const SlopeAgreement& slopes, const std::optional<Hints>& hints) {
    if (isWrongAsideAlone(hints)) return asideWords();
    if (slopes.fieldAgrees()) return teethWords(slopes);
    return {
        fmt::format("On pictures the tilt is not what it is on even ramps: on a smooth random map "
                    "{} of the tilt along u and {} of that along v keep to it (right code: all but "
                    "a few percent).",
                    percent(0.5 + 0.5 * slopes.fieldU), percent(0.5 + 0.5 * slopes.fieldV)),
        "Check that Bu compares two neighbouring texels of the point's own row, and Bv two of its "
        "own column; that columns are counted by width() and rows by height(); that u and v are "
        "made from position - centre() in x, y and z alike, for every sphere; and that nothing "
        "depends on how bright or how steep the texels are: no abs, and no type that is too small "
        "for a height (int8_t, char, uint8_t).",
        "Option 1: What to do, step 3"};
}

Words lettersWords(const LetterReading& letters) {
    return {
        fmt::format("On ramps the tilt is right, but on the letter map the H looks {} and the L "
                    "looks {}: expected are raised H and lowered L.",
                    look(letters.h, false), look(letters.l, true)),
        "Look for anything that treats steep slopes unlike gentle ones, or falling ones unlike "
        "rising ones.",
        "Option 1: Test it"};
}

struct Seen {
    const Examination& examination;
    const std::optional<Hints>& hints;
};

struct ReasonRow {
    WrongReason reason;
    Words (*words)(const Seen& told);
};

constexpr std::array kReasons{
    ReasonRow{WrongReason::chance,
              [](const Seen& told) { return chanceWords(told.examination.conduct.chance); }},
    ReasonRow{WrongReason::mapIgnored, [](const Seen&) { return mapIgnoredWords(); }},
    ReasonRow{WrongReason::remembers, [](const Seen&) { return remembersWords(); }},
    ReasonRow{WrongReason::dependsOnOrder, [](const Seen&) { return orderWords(); }},
    ReasonRow{WrongReason::normalMissing, [](const Seen&) { return normalMissingWords(); }},
    ReasonRow{WrongReason::inward, [](const Seen& told) { return inwardWords(told.examination); }},
    ReasonRow{WrongReason::flatTilted,
              [](const Seen& told) { return flatTiltedWords(told.examination.ladder.flatTilt); }},
    ReasonRow{
        WrongReason::normalsRounded,
        [](const Seen& told) { return roundedNormalWords(told.examination.ladder.sharedNormals); }},
    ReasonRow{WrongReason::slopeUIgnored, [](const Seen&) { return ignoredWords("u", "columns"); }},
    ReasonRow{WrongReason::slopeVIgnored, [](const Seen&) { return ignoredWords("v", "rows"); }},
    ReasonRow{WrongReason::signLost,
              [](const Seen& told) { return landingWords(told.examination, told.hints); }},
    ReasonRow{WrongReason::strangeParametrisation,
              [](const Seen& told) { return landingWords(told.examination, told.hints); }},
    ReasonRow{WrongReason::smallSlopesLost, [](const Seen&) { return smallSlopesWords(); }},
    ReasonRow{WrongReason::patchy,
              [](const Seen& told) {
                  if (isWrongAsideAlone(told.hints)) return asideWords();
                  if (told.hints && told.hints->square.kind == RampKind::right) return sizeWords();
                  return patchyWords(*told.examination.ramps().response);
              }},
    ReasonRow{WrongReason::strangeDirection,
              [](const Seen& told) {
                  return isWrongAsideAlone(told.hints)
                             ? asideWords()
                             : directionWords(*told.examination.ramps().response, told.hints);
              }},
    ReasonRow{WrongReason::doesNotGrow,
              [](const Seen& told) { return growthWords(told.examination); }},
    ReasonRow{WrongReason::heightsBent,
              [](const Seen& told) { return heightsBentWords(told.examination.proportion); }},
    ReasonRow{WrongReason::pastHorizon,
              [](const Seen& told) { return horizonWords(told.examination.proportion); }},
    ReasonRow{WrongReason::steepDiffers,
              [](const Seen& told) { return steepWords(told.examination.ladder.steepAgrees); }},
    ReasonRow{WrongReason::regionsDiffer,
              [](const Seen& told) { return regionWords(*told.examination.regions); }},
    ReasonRow{WrongReason::slopesDiffer,
              [](const Seen& told) { return slopesWords(*told.examination.slopes, told.hints); }},
    ReasonRow{WrongReason::wallAtSeam,
              [](const Seen& told) { return seamWords(*told.examination.edges); }},
    ReasonRow{WrongReason::coordinatesRounded,
              [](const Seen& told) { return roundedWords(*told.examination.fineness); }},
    ReasonRow{WrongReason::stepsLost,
              [](const Seen& told) { return lostStepsWords(*told.examination.balance); }},
    ReasonRow{WrongReason::fractionsMixed,
              [](const Seen& told) { return mixedWords(*told.examination.stripes); }},
    ReasonRow{WrongReason::lettersDiffer,
              [](const Seen& told) { return lettersWords(*told.examination.letters); }},
    ReasonRow{WrongReason::dependsOnEye,
              [](const Seen& told) { return eyeWords(told.examination.elsewhere); }},
    ReasonRow{WrongReason::turnedAtPoles,
              [](const Seen& told) { return capWords(*told.examination.caps); }},
    ReasonRow{WrongReason::fewTexelsDiffer,
              [](const Seen& told) { return fewTexelWords(*told.examination.fewTexels); }},
    ReasonRow{WrongReason::stepsUneven,
              [](const Seen& told) { return unevenWords(*told.examination.evenSteps); }},
    ReasonRow{WrongReason::sharpStepsTurned,
              [](const Seen& told) { return sharpStepWords(told.examination.sharpSteps); }},
    ReasonRow{WrongReason::besidePlanes,
              [](const Seen& told) { return beltWords(*told.examination.belts); }},
    ReasonRow{WrongReason::otherTexels,
              [](const Seen& told) { return otherTexelWords(*told.examination.ownTexels); }},
    ReasonRow{WrongReason::smallSphereDiffers,
              [](const Seen& told) { return smallSphereWords(*told.examination.slopes); }},
    ReasonRow{WrongReason::smoothInPlaces,
              [](const Seen& told) { return untiltedWords(told.examination.untilted); }},
};

}  // namespace

Words wrongWords(WrongReason reason, const Examination& examination,
                 const std::optional<Hints>& hints) {
    if (reason != WrongReason::chance && hints && hints->dependsOnOrder) return orderWords();
    return std::ranges::find(kReasons, reason, &ReasonRow::reason)->words({examination, hints});
}

}  // namespace ticker::tasks::bump
