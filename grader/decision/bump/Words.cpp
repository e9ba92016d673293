#include <grader/decision/bump/Words.h>

#include <grader/decision/bump/BumpEvidence.h>
#include <grader/decision/bump/Phrases.h>
#include <grader/decision/bump/WrongWords.h>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace ticker::decision::bump {
namespace {

Words threwWords(const Offence& offence) {
    const bool lookUp = offence.message.find("outside the map") != std::string::npos;
    // What a double that is not a number, or far too large, becomes as an int.
    const bool overflow = offence.message.find("2147483648") != std::string::npos;
    Words words;
    words.message = fmt::format("The program stops at {}: \"{}\". The first is {}.",
                                pointsOf(offence), quoted(offence.message), firstAt(offence));
    words.section = "Option 1: What to do, step 3";
    if (overflow)
        words.hint =
            "A u or v that is not a number became a column or row: look for an acos of a "
            "value beyond 1 (divide by the radius, or normalise, first).";
    else if (lookUp)
        words.hint =
            "Look at the line that turns (u, v) into a column and a row, and at the texels "
            "to the right and below: columns end at width() - 1 and rows at height() - 1. "
            "Let columns go round (modulo the width), and let rows stop at the edge. A size that "
            "is written in as a number, or remembered from another map (a static variable), leads "
            "outside as well: maps differ in size.";
    else
        words.hint = "An exception came out of getNormalAt. A render would end there.";
    return words;
}

Words notFiniteWords(const Offence& offence) {
    return {fmt::format("The normal is not a number at {}; the first is {}. Every point of the "
                        "sphere needs a unit vector.",
                        pointsOf(offence), firstAt(offence)),
            "Look for an acos or asin of a value beyond 1 (divide by the radius, or normalise, "
            "first), a division by a slope or a sine that can be zero, and a vector of length zero "
            "that is normalised.",
            "Option 1: What to do, steps 1 and 4"};
}

Words notUnitWords(const Offence& offence) {
    return {fmt::format("The normal should have length 1, but at {} it does not: the length is off "
                        "by up to {:.2g}.",
                        pointsOf(offence), offence.value),
            "Equation (1) normalises the sum: call normalised() on what you return.",
            "Option 1: The sign trap"};
}

Words flatWords() {
    return {
        "The sphere is smooth: no slope of the bump map tilts the normal, not even a step from "
        "black to white.",
        "Check that Bu and Bv are used in the vector that is returned, and that they are not "
        "always zero (a texel minus itself, a division of integers).",
        "Option 1: What to do, steps 3 and 4"};
}

Words longitudeWords(const Examination& examination) {
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
        "(u, v) that you look up: differentiate your own F(u, v), Equation (2), at the point's own "
        "longitude and polar angle.";
    words.section = "Option 1: What to do, step 2";
    return words;
}

Words swappedWords(const Examination& examination, const std::optional<Hints>& hints) {
    const bool transposed = examination.ramps().transposed || (hints && hints->square.transposed);
    if (transposed)
        return {
            "Columns and rows are exchanged: moving round the sphere reads other rows of the "
            "map, moving down reads other columns.",
            "heightMap().at takes the column first: at(column, row); u chooses the column, v "
            "the row.",
            "Option 1: What to do, step 1"};
    return {
        "The axes are exchanged: a slope along u tilts the normal along v, and a slope along v "
        "tilts it along u.",
        "In Equation (1) Bu goes with n x Pv, which is a vector along Pu, and Bv with n x Pu. "
        "Written without cross products Bu goes with Pu and Bv with Pv.",
        "Option 1: The sign trap"};
}

constexpr const char* kOneSign =
    " Equation (1), taken literally with both slopes measured the same way, inverts exactly one "
    "axis.";

Words invertedWords() {
    return {
        "The bumps are inverted along both axes: bright texels are lowered and dark ones "
        "raised, so that H sinks and L stands out.",
        "Both signs are wrong. Measure both slopes the other way (the neighbour minus this "
        "texel), or change both signs where you tilt the normal, not both of these: a surface "
        "that rises along a tangent leans back against it.",
        "Option 1: Test it"};
}

/// What an inverted axis is called, and which of a letter's edges show it.
struct AxisNames {
    const char* axis;
    const char* other;
    const char* rise;
    const char* wrongEdges;
    const char* rightEdges;
};
constexpr AxisNames kAxisU{"u", "v", "to the right", "left and right", "upper and lower"};
constexpr AxisNames kAxisV{"v", "u", "downwards", "upper and lower", "left and right"};

Words invertedAxisWords(const AxisNames& names) {
    return {
        fmt::format("Along {0} the bumps are inverted: where the map gets brighter {2}, the "
                    "normal leans that way instead of back against it. Along {1} it is right. So "
                    "the {3} edges of an H look lowered, and its {4} edges raised.",
                    names.axis, names.other, names.rise, names.wrongEdges, names.rightEdges),
        fmt::format("One sign is wrong: either in the difference that makes B{0}, or before the "
                    "term with B{0}. Change one of the two, and leave B{1} alone.{2}",
                    names.axis, names.other, kOneSign),
        "Option 1: The sign trap; What to do, step 3"};
}

Words upsideDownWords() {
    return {
        "The map stands on its head: its top row lies at the bottom of the sphere. Bumps and "
        "hollows are right.",
        "Row 0 is the top of the picture: v must be 0 at the top of the sphere (the largest y) "
        "and 1 at the bottom.",
        "Option 1: What to do, step 1"};
}

/// What is said of a sign while the map stands on its head, too: turned round, it may be right.
Words signOnItsHeadWords(Words sign) {
    const Words place = upsideDownWords();
    sign.message +=
        " The map stands on its head as well: its top row lies at the bottom of the "
        "sphere.";
    sign.hint = "Turn the map round first, and check again. " + place.hint +
                " That may mend the sign, too; if it does not: " + sign.hint;
    sign.section = "Option 1: What to do, steps 1 to 3; The sign trap";
    return sign;
}

bool isSign(Fault fault) {
    return fault == Fault::inverted || fault == Fault::invertedU || fault == Fault::invertedV;
}

Words wordsFor(Fault fault, const Examination& examination, const std::optional<Hints>& hints) {
    switch (fault) {
        case Fault::threw:
            return threwWords(examination.conduct.threw);
        case Fault::notFinite:
            return notFiniteWords(examination.conduct.notFinite);
        case Fault::notUnit:
            return notUnitWords(examination.conduct.notUnit);
        case Fault::flat:
            return flatWords();
        case Fault::longitudeDependent:
            return longitudeWords(examination);
        case Fault::swapped:
            return swappedWords(examination, hints);
        case Fault::inverted:
            return invertedWords();
        case Fault::invertedU:
            return invertedAxisWords(kAxisU);
        case Fault::invertedV:
            return invertedAxisWords(kAxisV);
        case Fault::upsideDown:
            return upsideDownWords();
        case Fault::wrong:
            return wrongWords(*findWrong(examination), examination, hints);
    }
    return {};
}

Finding note(const std::string& id, Severity severity, Words words) {
    Finding finding;
    finding.id = id;
    finding.severity = severity;
    finding.message = std::move(words.message);
    finding.hint = std::move(words.hint);
    finding.section = std::move(words.section);
    return finding;
}

Finding mirroredNote() {
    return note(
        "bump.mirrored", Severity::note,
        {"The map is mirrored: text on it reads from right to left. That alone is accepted.",
         "Let u grow to the right as seen from outside.", "Option 1: What to do, step 1"});
}

}  // namespace

Finding describe(const std::vector<Fault>& faults, const Examination& examination,
                 const std::optional<Hints>& hints) {
    Words words = wordsFor(faults.front(), examination, hints);
    if (isSign(faults.front()) && standsOnItsHead(examination))
        words = signOnItsHeadWords(std::move(words));
    Finding finding = note(idOf(faults.front()), Severity::fail, std::move(words));
    finding.evidence = evidenceOf(faults, examination);
    return finding;
}

std::vector<Finding> sideNotes(const Examination& examination) {
    const Conduct& conduct = examination.conduct;
    std::vector<Finding> notes;
    if (conduct.threwHidden)
        notes.push_back(note("run.crashed", Severity::warn, threwWords(conduct.threwHidden)));
    if (conduct.notFiniteHidden)
        notes.push_back(
            note("bump.not-finite", Severity::warn, notFiniteWords(conduct.notFiniteHidden)));
    if (conduct.notUnitHidden)
        notes.push_back(note("bump.not-unit", Severity::warn, notUnitWords(conduct.notUnitHidden)));
    // What reads from right to left on its head may do so from left to right on its feet, and what
    // is seen from inside says nothing.
    const bool placed = examination.ramps().response.has_value() && !standsOnItsHead(examination) &&
                        !pointsInwards(examination);
    if (placed && examination.ramps().fit->landing.mirrored()) notes.push_back(mirroredNote());
    for (Finding& finding : notes)
        if (finding.severity == Severity::warn)
            finding.message +=
                " No usual picture shows these points (poles, the far side's exact "
                "middle, maps of 4 x 4 texels), so this alone fails nothing.";
    return notes;
}

}  // namespace ticker::decision::bump
