#include <grader/result/GeneralFindings.h>
#include <grader/tasks/bump/BumpFindings.h>
#include <grader/tasks/bump/words/Diagnosis.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace ticker::tasks::bump {
namespace {

// A tilt of a thousandth changes no pixel by a grey step, not even at an edge from black to white.
constexpr double kVisibleTilt = 1e-3;

/// Names a sign only if every map agrees: an inversion in some rows or greys alone is not a matter
/// of one sign.
std::optional<Fault> faultOf(const Examination& examination) {
    const bool agrees = examination.agreesWithRamps();
    switch (examination.ramps().kind) {
        case RampKind::longitudeDependent:
            return Fault::longitudeDependent;
        case RampKind::swapped:
            return Fault::swapped;
        case RampKind::inverted:
            return agrees ? std::optional(Fault::inverted) : std::nullopt;
        case RampKind::invertedU:
            return agrees ? std::optional(Fault::invertedU) : std::nullopt;
        case RampKind::invertedV:
            return agrees ? std::optional(Fault::invertedV) : std::nullopt;
        default:
            return std::nullopt;
    }
}

bool isFlat(const Examination& examination) {
    const Conduct& conduct = examination.conduct;
    return !conduct.inward && !conduct.threw && !conduct.notFinite &&
           !(conduct.largestTilt > kVisibleTilt);
}

/// True if a flat map tilts the normal. The differences that ramps make then say nothing.
bool tiltsWithoutSlope(const Examination& examination) {
    // Normals of chords over a hundredth of the map lean by 0.03; smaller tilts are subtracted.
    constexpr double kFlatTilt = 0.1;
    return examination.ladder.flatTilt > kFlatTilt;
}

/// Any strength is right that leaves some of the normal: a strength of 20 leaves 0.001 on these
/// ramps.
bool liesFlat(const Examination& examination) {
    constexpr double kFlat = 1e3;
    const RampStrength& strength = examination.ramps().strength;
    return std::max(strength.alongU, strength.alongV) > kFlat;
}

bool growsWithSlope(const Examination& examination) {
    return examination.ladder.growsWithSlope && examination.proportion.good();
}

std::optional<WrongReason> reasonOf(RampKind kind) {
    switch (kind) {
        case RampKind::silent:
            return WrongReason::smallSlopesLost;
        case RampKind::slopeUIgnored:
            return WrongReason::slopeUIgnored;
        case RampKind::slopeVIgnored:
            return WrongReason::slopeVIgnored;
        case RampKind::signLost:
            return WrongReason::signLost;
        case RampKind::strangeParametrisation:
            return WrongReason::strangeParametrisation;
        case RampKind::patchy:
            return WrongReason::patchy;
        case RampKind::strangeDirection:
            return WrongReason::strangeDirection;
        default:
            return std::nullopt;
    }
}

/// True if each axis has one sense on the ramps, right or inverted.
bool hasSenses(RampKind kind) {
    return kind == RampKind::right || kind == RampKind::inverted || kind == RampKind::invertedU ||
           kind == RampKind::invertedV;
}

/// The reason if other maps disagree with the ramps.
std::optional<WrongReason> findDisagreement(const Examination& examination) {
    if (examination.agreesWithRamps()) return std::nullopt;
    const bool regionsDiffer = examination.regions && !examination.regions->good();
    // Names the rows and columns if only some are wrong.
    if (regionsDiffer && examination.regions->isLocal()) return WrongReason::regionsDiffer;
    if (!examination.slopes || !examination.slopes->good()) return WrongReason::slopesDiffer;
    return regionsDiffer ? WrongReason::regionsDiffer : WrongReason::steepDiffers;
}

/// A look-up with columns and rows exchanged leaves the map unless the map is square. So square
/// maps decide.
bool isTransposed(const Examination& examination, const std::optional<Hints>& hints) {
    const bool unclear = !examination.ramps().response;
    return unclear && (examination.ramps().transposed || (hints && hints->square.transposed));
}

}  // namespace

const FindingText& textOf(Fault fault) {
    static constexpr std::array kTexts{&kRunCrashed,
                                       &kBumpNotFinite,
                                       &kBumpNotUnit,
                                       &kBumpFlat,
                                       &kBumpLongitudeDependent,
                                       &kBumpSwappedAxes,
                                       &kBumpInverted,
                                       &kBumpInvertedU,
                                       &kBumpInvertedV,
                                       &kBumpUpsideDown,
                                       &kBumpWrong};
    return *kTexts.at(static_cast<std::size_t>(fault));
}

std::optional<WrongReason> findWrong(const Examination& examination) {
    // Half a degree; observed changes are larger.
    constexpr double kSomeChange = 0.01;
    if (examination.conduct.chance > kSomeChange) return WrongReason::chance;
    if (examination.mapIgnored) return WrongReason::mapIgnored;
    const Offence& inward = examination.conduct.inward;
    const RampKind kind = examination.ramps().kind;
    if (liesFlat(examination)) return WrongReason::normalMissing;
    // Wrong tangents turn a few normals inwards; the tangents are then the fault.
    if (inward.count > 0.5 * inward.asked) return WrongReason::inward;
    if (tiltsWithoutSlope(examination)) return WrongReason::flatTilted;
    if (kind == RampKind::strangeParametrisation && !growsWithSlope(examination))
        return WrongReason::doesNotGrow;
    if (const auto reason = reasonOf(kind)) return reason;
    if (!hasSenses(kind)) return std::nullopt;
    if (const auto reason = findDisagreement(examination)) return reason;
    // The remaining reasons concern submissions that are right on ramps.
    if (kind != RampKind::right) return std::nullopt;
    // Tangents at the texel's corner turn a very strong tilt inwards at the seam's step.
    constexpr double kSomeInward = 0.01;
    if (inward.count > kSomeInward * inward.asked) return WrongReason::inward;
    if (!growsWithSlope(examination)) return WrongReason::doesNotGrow;
    if (!examination.proportion.staysAboveHorizon()) return WrongReason::pastHorizon;
    if (examination.conduct.memory > kSomeChange) return WrongReason::remembers;
    if (examination.edges && !examination.edges->goodSeam()) return WrongReason::wallAtSeam;
    if (examination.fineness && !examination.fineness->good())
        return WrongReason::coordinatesRounded;
    if (!examination.letters || !examination.letters->good()) return WrongReason::lettersDiffer;
    return std::nullopt;
}

bool standsOnItsHead(const Examination& examination) {
    // Downwards, within 45 degrees of straight down.
    constexpr double kDownwards = -0.7;
    return examination.ramps().response.has_value() &&
           examination.ramps().fit->parametrisation.axis().y < kDownwards;
}

bool pointsInwards(const Examination& examination) {
    // Wrong tangents turn some normals inwards, and a normal turned to the camera about half.
    constexpr double kNearlyAll = 0.9;
    const Offence& inward = examination.conduct.inward;
    return inward.count > kNearlyAll * inward.asked;
}

std::vector<Fault> diagnose(const Examination& examination, const std::optional<Hints>& hints) {
    if (isTransposed(examination, hints)) return {Fault::swapped};
    std::vector<Fault> faults;
    const Conduct& conduct = examination.conduct;
    if (conduct.threw) faults.push_back(Fault::threw);
    if (conduct.notFinite) faults.push_back(Fault::notFinite);
    if (conduct.notUnit) faults.push_back(Fault::notUnit);
    if (isFlat(examination)) {
        faults.push_back(Fault::flat);
        return faults;
    }
    // Missing answers and answers that are not finite explain all other oddities.
    const bool incomplete = conduct.threw || conduct.notFinite;
    const bool inward = !incomplete && pointsInwards(examination);
    // Seen from inside, signs and the map's place differ from those in the code.
    if (inward) faults.push_back(Fault::wrong);
    const bool telling = !tiltsWithoutSlope(examination);
    if (const auto fault = faultOf(examination); fault && telling) faults.push_back(*fault);
    if (telling && standsOnItsHead(examination)) faults.push_back(Fault::upsideDown);
    if (!incomplete && !inward && findWrong(examination)) faults.push_back(Fault::wrong);
    return faults;
}

}  // namespace ticker::tasks::bump
