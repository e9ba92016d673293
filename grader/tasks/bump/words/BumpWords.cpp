#include <grader/result/GeneralFindings.h>
#include <grader/tasks/bump/BumpFindings.h>
#include <grader/tasks/bump/words/BumpWords.h>

#include <grader/tasks/bump/words/BumpEvidence.h>
#include <grader/tasks/bump/words/GrowthWords.h>
#include <grader/tasks/bump/words/Phrases.h>
#include <grader/tasks/bump/words/SignWords.h>
#include <grader/tasks/bump/words/WrongWords.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ticker::tasks::bump {
namespace {

/// True of columns below -1, which no neighbour on the left has.
bool isFarLeft(const std::string& message) {
    return message.find("column -") != std::string::npos &&
           message.find("column -1,") == std::string::npos;
}

constexpr const char* kNegativeU =
    "u is negative there: std::atan2 gives a longitude between -pi and pi, so that u is the "
    "longitude over 2 pi plus 0.5. ";

Words threwWords(const Offence& offence) {
    const bool lookUp = offence.message.find("outside the map") != std::string::npos;
    // What a NaN, or a double that is far too large, becomes as an int.
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
            std::string{isFarLeft(offence.message) ? kNegativeU : ""} +
            "Look at the line that turns (u, v) into a column and a row, and at the neighbours: "
            "columns end at width() - 1 and rows at height() - 1. Let columns go round with "
            "(column + 1) % width() to the right and (column - 1 + width()) % width() to the left "
            "(-1 % width() stays -1), and let rows stop at the edge. A size that is written in as "
            "a number, or remembered from another map (a static variable), leads outside as well: "
            "maps differ in size.";
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
            "that is normalised, such as a sum without n where the map is level: normalise nothing "
            "but the whole sum with n, as a test for zero only hides this.",
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
        "Bu goes with Pu and Bv with Pv: write Equation (1) as it stands, signs too, n - Bu Pu - "
        "Bv Pv. With cross products Bu goes with n x Pv and Bv with n x Pu. Where these pairs are "
        "right by name, the tangents themselves are exchanged: Pu is the derivative by the angle "
        "that chooses the column, along the circle of latitude, and Pv that by the angle that "
        "chooses the row, along the meridian.",
        "Option 1: The sign trap; What to do, step 2"};
}

/// Adds to the words of an exception those of the fault that the answered points show.
void addNext(Words& words, const Words& next) {
    words.message += " Where it answers, another mistake shows: " + next.message;
    words.hint += " Then: " + next.hint;
    words.section += "; " + next.section.substr(next.section.find(": ") + 2);
}

bool isSign(Fault fault) {
    return fault == Fault::inverted || fault == Fault::invertedU || fault == Fault::invertedV;
}

struct Told {
    const Examination& examination;
    const std::optional<Hints>& hints;
    std::optional<WrongReason> wrong;
};

struct FaultRow {
    Fault fault;
    const FindingText* text;
    Words (*words)(const Told& told);
};

/// In the order of Fault.
constexpr std::array kFaults{
    FaultRow{Fault::threw, &kRunCrashed,
             [](const Told& told) { return threwWords(told.examination.conduct.threw); }},
    FaultRow{Fault::notFinite, &kBumpNotFinite,
             [](const Told& told) { return notFiniteWords(told.examination.conduct.notFinite); }},
    FaultRow{Fault::notUnit, &kBumpNotUnit,
             [](const Told& told) { return notUnitWords(told.examination.conduct.notUnit); }},
    FaultRow{Fault::flat, &kBumpFlat, [](const Told&) { return flatWords(); }},
    FaultRow{Fault::longitudeDependent, &kBumpLongitudeDependent,
             [](const Told& told) { return longitudeWords(told.examination); }},
    FaultRow{Fault::swapped, &kBumpSwappedAxes,
             [](const Told& told) { return swappedWords(told.examination, told.hints); }},
    FaultRow{Fault::inverted, &kBumpInverted, [](const Told&) { return invertedWords(); }},
    FaultRow{Fault::invertedU, &kBumpInvertedU, [](const Told&) { return invertedUWords(); }},
    FaultRow{Fault::invertedV, &kBumpInvertedV, [](const Told&) { return invertedVWords(); }},
    FaultRow{Fault::upsideDown, &kBumpUpsideDown, [](const Told&) { return upsideDownWords(); }},
    FaultRow{Fault::wrong, &kBumpWrong,
             [](const Told& told) {
                 return wrongWords(told.wrong.value(), told.examination, told.hints);
             }},
};

const FaultRow& rowOf(Fault fault) {
    return *std::ranges::find(kFaults, fault, &FaultRow::fault);
}

Finding note(const FindingText& text, Severity severity, Words words) {
    Finding finding;
    finding.id = text.id;
    finding.severity = severity;
    finding.message = std::move(words.message);
    finding.hint = std::move(words.hint);
    finding.section = std::move(words.section);
    return finding;
}

Finding mirroredNote() {
    return note(
        kBumpMirrored, Severity::note,
        {"The map is mirrored: text on it reads from right to left. That alone is accepted.",
         "Let u grow to the right as seen from outside.", "Option 1: What to do, step 1"});
}

Finding endRowsWarning(const MapEdges& edges) {
    return note(
        kBumpWrong, Severity::warn,
        {fmt::format(
             "In the map's first or last row the normal tilts {} times as far as anywhere "
             "else, on a map of a gentle wave: what lies beyond that row counts as a height "
             "that the map does not have.",
             edges.endRows < 100.0 ? fmt::format("{:.0f}", edges.endRows) : "over 100"),
         "Below the last row there is nothing, so it is level downwards: take "
         "std::min(row + 1, height() - 1) as its neighbour.",
         "Option 1: What to do, step 3"});
}

}  // namespace

const FindingText& textOf(Fault fault) {
    return *rowOf(fault).text;
}

Finding describe(const Diagnosis& diagnosis, const Examination& examination,
                 const std::optional<Hints>& hints) {
    const std::vector<Fault>& faults = diagnosis.faults;
    const Told told{examination, hints, diagnosis.wrong};
    Words words = rowOf(faults.front()).words(told);
    if (faults.front() == Fault::threw && faults.size() > 1)
        addNext(words, rowOf(faults[1]).words(told));
    if (isSign(faults.front()) && standsOnItsHead(examination))
        words = signOnItsHeadWords(std::move(words));
    Finding finding = note(textOf(faults.front()), Severity::fail, std::move(words));
    finding.evidence = evidenceOf(faults, examination);
    return finding;
}

std::vector<Finding> sideNotes(const Examination& examination) {
    const Conduct& conduct = examination.conduct;
    std::vector<Finding> notes;
    if (conduct.threwHidden)
        notes.push_back(note(kRunCrashed, Severity::warn, threwWords(conduct.threwHidden)));
    if (conduct.notFiniteHidden)
        notes.push_back(
            note(kBumpNotFinite, Severity::warn, notFiniteWords(conduct.notFiniteHidden)));
    if (conduct.notUnitHidden)
        notes.push_back(note(kBumpNotUnit, Severity::warn, notUnitWords(conduct.notUnitHidden)));
    if (examination.edges && examination.edges->goodSeam() && !examination.edges->goodEndRows())
        notes.push_back(endRowsWarning(*examination.edges));
    // A text that is mirrored on an upside-down map may be right once the map is turned round. A
    // view from inside the sphere says nothing.
    const bool placed = examination.ramps().response.has_value() && !standsOnItsHead(examination) &&
                        !pointsInwards(examination);
    if (placed && examination.ramps().fit->parametrisation.mirrored())
        notes.push_back(mirroredNote());
    for (Finding& finding : notes)
        if (finding.severity == Severity::warn)
            finding.message +=
                " No usual picture shows these points (poles, the far side's exact "
                "middle, maps of 4 x 4 texels), so this alone fails nothing.";
    return notes;
}

}  // namespace ticker::tasks::bump
