#include <grader/decision/bump/Words.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ticker::decision::bump {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Message, hint and section of one finding.
struct Words {
    std::string message;
    std::string hint;
    std::string section;
};

std::string percent(double share) {
    const double value = 100.0 * share;
    return value > 0.0 && value < 1.0 ? fmt::format("{:.2g} %", value)
                                      : fmt::format("{:.0f} %", value);
}

/// What the student's code said, as one harmless line.
std::string quoted(const std::string& text) {
    constexpr std::size_t kLongest = 160;
    std::string line = text.substr(0, kLongest);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return line.size() < text.size() ? line + "..." : line;
}

std::string pointsOf(const Offence& offence) {
    return fmt::format("{:.0f} of {:.0f} points", offence.count, offence.asked);
}

std::string firstAt(const Offence& offence) {
    return fmt::format("{}, on a map of {} x {} texels", placeInWords(offence.direction),
                       offence.width, offence.height);
}

Words threwWords(const Offence& offence) {
    const bool lookUp = offence.message.find("outside the map") != std::string::npos;
    // What a double that is not a number, or far too large, becomes as an int.
    const bool overflow = offence.message.find("2147483648") != std::string::npos;
    Words words;
    words.message = fmt::format("The program stops at {}: \"{}\". The first is {}.",
                                pointsOf(offence), quoted(offence.message), firstAt(offence));
    words.section = "1, Implementation, step 3";
    if (overflow)
        words.hint =
            "A u or v that is not a number became a column or row: look for an acos of a "
            "value beyond 1 (divide by the radius, or normalise, first).";
    else if (lookUp)
        words.hint =
            "Look at the line that turns (u, v) into a column and a row, and at the texels "
            "to the right and below: columns end at width() - 1 and rows at height() - 1. "
            "Let columns go round (modulo the width), and let rows stop at the edge.";
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
            "1, Implementation, steps 1 and 4"};
}

Words notUnitWords(const Offence& offence) {
    return {fmt::format("The normal should have length 1, but at {} it does not: the length is off "
                        "by up to {:.2g}.",
                        pointsOf(offence), offence.value),
            "Equation (1) normalises the sum: call normalised() on what you return.",
            "1, Theory, Equation (1)"};
}

Words flatWords() {
    return {
        "The sphere is smooth: no slope of the bump map tilts the normal, not even a step from "
        "black to white.",
        "Check that Bu and Bv are used in the vector that is returned, and that they are not "
        "always zero (a texel minus itself, a division of integers).",
        "1, Implementation, steps 3 and 4"};
}

Words longitudeWords(const Examination& examination) {
    const double turn = examination.ramps.response->tangentTurn;
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
    words.section = "1, Implementation, step 2";
    return words;
}

Words swappedWords(const Examination& examination, const std::optional<Hints>& hints) {
    const bool transposed = examination.ramps.transposed || (hints && hints->square.transposed);
    if (transposed)
        return {
            "Columns and rows are exchanged: moving round the sphere reads other rows of the "
            "map, moving down reads other columns.",
            "heightMap().at takes the column first: at(column, row); u chooses the column, v "
            "the row.",
            "1, Implementation, step 1"};
    return {
        "The axes are exchanged: a slope along u tilts the normal along v, and a slope along v "
        "tilts it along u.",
        "In Equation (1) Bu goes with n x Pv, which is a vector along Pu, and Bv with n x Pu. "
        "Written without cross products Bu goes with Pu and Bv with Pv.",
        "1, Theory, Equation (1)"};
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
        "1, Testing"};
}

Words invertedAxisWords(const std::string& axis, const std::string& other,
                        const std::string& rise) {
    return {
        fmt::format("Along {0} the bumps are inverted: where the map gets brighter {2}, the "
                    "normal leans that way instead of back against it. Along {1} it is right.",
                    axis, other, rise),
        fmt::format("One sign is wrong: either in the difference that makes B{0}, or before the "
                    "term with B{0}. Change one of the two, and leave B{1} alone.{2}",
                    axis, other, kOneSign),
        "1, Theory, Equation (1); 1, Implementation, step 3"};
}

Words upsideDownWords() {
    return {
        "The map stands on its head: its top row lies at the bottom of the sphere. Bumps and "
        "hollows are right.",
        "Row 0 is the top of the picture: v must be 0 at the top of the sphere (the largest y) "
        "and 1 at the bottom.",
        "1, Implementation, step 1"};
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

Words wrongWords(WrongReason reason, const Examination& examination,
                 const std::optional<Hints>& hints) {
    switch (reason) {
        case WrongReason::inward:
            return {fmt::format("The normal points into the sphere at {}; the first is {}.",
                                pointsOf(examination.conduct.inward),
                                firstAt(examination.conduct.inward)),
                    "The smooth normal is position minus centre, not the other way round; with a "
                    "cross product of two tangents, mind their order.",
                    "1, Implementation, step 1"};
        case WrongReason::flatTilted:
            return {fmt::format("On a map without any slope the normal should be the smooth "
                                "sphere's, but it is tilted by {:.0f} degrees (median).",
                                std::atan(examination.flatTilt) * kDegrees),
                    "The tilt must come from differences of heights, not from heights, and must be "
                    "added to the unit normal, (position - centre) / radius.",
                    "1, Implementation, steps 1 and 3"};
        case WrongReason::slopeUIgnored:
            return ignoredWords("u", "columns");
        case WrongReason::slopeVIgnored:
            return ignoredWords("v", "rows");
        case WrongReason::signLost:
            return signLostWords(hints);
        case WrongReason::strangeLanding:
            return strangeLandingWords(examination, hints);
        case WrongReason::smallSlopesLost:
            return {"Steps of the map tilt the normal, but even slopes tilt nothing.",
                    "Heights are fractions from 0 to 5: look for an int that cuts a difference "
                    "off, or for a step that reads the same texel twice.",
                    "1, Implementation, step 3"};
        case WrongReason::patchy:
            return patchyWords(*examination.ramps.response);
        case WrongReason::strangeDirection:
            return directionWords(*examination.ramps.response);
        case WrongReason::doesNotGrow:
            return {
                "A slope that is 50 times as steep tilts the normal hardly more: a bigger "
                "bump should give a larger coefficient.",
                "Do not normalise the slopes, and do not cut them off: only the sum of "
                "Equation (1) is normalised.",
                "1, Theory"};
        case WrongReason::steepDiffers:
            return {"Steep slopes tilt the normal in another direction than gentle ones.",
                    "Bu and Bv should be in proportion to the differences of the heights.",
                    "1, Theory"};
        case WrongReason::slopesDiffer:
            return slopesWords(*examination.slopes);
        case WrongReason::lettersDiffer:
            return lettersWords(*examination.letters);
    }
    return {};
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
            return invertedAxisWords("u", "v", "to the right");
        case Fault::invertedV:
            return invertedAxisWords("v", "u", "downwards");
        case Fault::upsideDown:
            return upsideDownWords();
        case Fault::wrong:
            return wrongWords(*findWrong(examination), examination, hints);
    }
    return {};
}

std::vector<double> toVector(const std::array<double, kBands>& values) {
    return {values.begin(), values.end()};
}

void addAxis(Evidence& evidence, const std::string& name, const AxisResponse& axis) {
    evidence.emplace_back(name + "Right", axis.shares.right);
    evidence.emplace_back(name + "Inverted", axis.shares.inverted);
    evidence.emplace_back(name + "Across", axis.shares.across);
    evidence.emplace_back(name + "Dead", axis.shares.dead);
    evidence.emplace_back(name + "DirectionByBandDegrees", toVector(axis.bandDirection));
    evidence.emplace_back(name + "StrengthRatioOverLongitude", axis.strengthRatio);
}

void addEdges(Evidence& evidence, const std::string& name, const EdgeCount& edges) {
    evidence.emplace_back(name, fmt::format("{} of {} right, {} inverted, {} lost", edges.right,
                                            edges.crossed(), edges.opposite, edges.lost));
}

void addLetters(Evidence& evidence, const LetterReading& letters) {
    evidence.emplace_back("letterH", look(letters.h, false));
    evidence.emplace_back("letterL", look(letters.l, true));
    addEdges(evidence, "letterHAlongU", letters.h.alongU);
    addEdges(evidence, "letterHAlongV", letters.h.alongV);
    addEdges(evidence, "letterLAlongU", letters.l.alongU);
    addEdges(evidence, "letterLAlongV", letters.l.alongV);
}

void addLanding(Evidence& evidence, const LandingFit& fit) {
    const Vector3& axis = fit.landing.axis();
    evidence.emplace_back("topOfMap", std::vector<double>{axis.x, axis.y, axis.z});
    evidence.emplace_back("uFacingTheCamera", fit.landing.u({0.0, 0.0, -1.0}));
    evidence.emplace_back("mirrored", fit.landing.mirrored());
    evidence.emplace_back("strayShare", fit.strayShare);
}

void addOffence(Evidence& evidence, const std::string& name, const Offence& offence) {
    if (!offence) return;
    evidence.emplace_back(name + "Points", offence.count);
    evidence.emplace_back(name + "Asked", offence.asked);
    evidence.emplace_back(name + "FirstAt", placeInWords(offence.direction));
}

Evidence evidenceOf(const std::vector<Fault>& faults, const Examination& examination) {
    Evidence evidence;
    std::string also;
    for (std::size_t i = 1; i < faults.size(); ++i)
        also += (also.empty() ? "" : ", ") + idOf(faults[i]);
    if (!also.empty()) evidence.emplace_back("also", also);
    if (examination.letters) addLetters(evidence, *examination.letters);
    if (examination.ramps.response) {
        const ResponseMatrix& m = examination.ramps.response->matrix;
        evidence.emplace_back("responseMatrix",
                              std::vector<double>{m[0][0], m[0][1], m[1][0], m[1][1]});
        addAxis(evidence, "u", examination.ramps.response->u);
        addAxis(evidence, "v", examination.ramps.response->v);
    }
    if (examination.ramps.fit) addLanding(evidence, *examination.ramps.fit);
    addOffence(evidence, "exception", examination.conduct.threw);
    addOffence(evidence, "notFinite", examination.conduct.notFinite);
    addOffence(evidence, "notUnit", examination.conduct.notUnit);
    addOffence(evidence, "inward", examination.conduct.inward);
    evidence.emplace_back("largestTiltDegrees",
                          std::atan(examination.conduct.largestTilt) * kDegrees);
    return evidence;
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
        {"The map is mirrored: text on it reads from right to left. The bumps are right, so "
         "this is accepted.",
         "Let u grow to the right as seen from outside.", "1, Implementation, step 1"});
}

}  // namespace

std::string idOf(Fault fault) {
    switch (fault) {
        case Fault::threw:
            return "run.crashed";
        case Fault::notFinite:
            return "bump.not-finite";
        case Fault::notUnit:
            return "bump.not-unit";
        case Fault::flat:
            return "bump.flat";
        case Fault::longitudeDependent:
            return "bump.longitude-dependent";
        case Fault::swapped:
            return "bump.swapped-axes";
        case Fault::inverted:
            return "bump.inverted";
        case Fault::invertedU:
            return "bump.inverted-u";
        case Fault::invertedV:
            return "bump.inverted-v";
        case Fault::upsideDown:
            return "bump.upside-down";
        case Fault::wrong:
            break;
    }
    return "bump.wrong";
}

Finding describe(const std::vector<Fault>& faults, const Examination& examination,
                 const std::optional<Hints>& hints) {
    Finding finding =
        note(idOf(faults.front()), Severity::fail, wordsFor(faults.front(), examination, hints));
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
    if (examination.ramps.response && examination.ramps.fit->landing.mirrored())
        notes.push_back(mirroredNote());
    for (Finding& finding : notes)
        if (finding.severity == Severity::warn)
            finding.message +=
                " No usual picture shows these points (poles, the far side's exact "
                "middle, maps of 4 x 4 texels), so this alone fails nothing.";
    return notes;
}

std::string placeInWords(const Vector3& direction) {
    const double latitude = std::asin(std::clamp(direction.y, -1.0, 1.0)) * kDegrees;
    const double longitude = std::atan2(direction.x, -direction.z) * kDegrees;
    if (std::abs(latitude) > 89.9) return latitude > 0.0 ? "at the top pole" : "at the bottom pole";
    return fmt::format(
        "{:.1f} degrees {} the equator and {:.1f} degrees {} of the meridian nearest "
        "to the camera",
        std::abs(latitude), latitude < 0.0 ? "below" : "above", std::abs(longitude),
        longitude < 0.0 ? "left" : "right");
}

}  // namespace ticker::decision::bump
