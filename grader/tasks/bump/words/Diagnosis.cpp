#include <grader/result/GeneralFindings.h>
#include <grader/tasks/bump/BumpFindings.h>
#include <grader/tasks/bump/words/Diagnosis.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace ticker::tasks::bump {
namespace {

// A tilt of a thousandth changes no pixel by as much as a grey step, not even at a step from black
// to white.
constexpr double kVisibleTilt = 1e-3;

/// A sign is named only where every map agrees: what is inverted in some rows or greys alone is no
/// matter of one sign.
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

/// Where a flat map tilts the normal, what ramps add to that says nothing.
bool tiltsWithoutSlope(const Examination& examination) {
    // Normals of chords over a hundredth of the map lean by 0.03; what leans less is made up for.
    constexpr double kFlatTilt = 0.1;
    return examination.ladder.flatTilt > kFlatTilt;
}

/// Any strength is right that leaves something of the normal: on these ramps a strength of 20 tilts
/// by 0.001.
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

/// Each axis has one sense on the ramps, right or inverted.
bool hasSenses(RampKind kind) {
    return kind == RampKind::right || kind == RampKind::inverted || kind == RampKind::invertedU ||
           kind == RampKind::invertedV;
}

/// Where other maps do not say what the ramps say.
std::optional<WrongReason> findDisagreement(const Examination& examination) {
    if (examination.agreesWithRamps()) return std::nullopt;
    const bool regionsDiffer = examination.regions && !examination.regions->good();
    // Which rows and columns, where it is a matter of these.
    if (regionsDiffer && examination.regions->isLocal()) return WrongReason::regionsDiffer;
    if (!examination.slopes || !examination.slopes->good()) return WrongReason::slopesDiffer;
    return regionsDiffer ? WrongReason::regionsDiffer : WrongReason::steepDiffers;
}

/// A look-up with columns and rows exchanged leaves maps that are not square: the square ones tell.
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
    // Half a degree: what is seen is above that.
    constexpr double kSomeChange = 0.01;
    if (examination.conduct.chance > kSomeChange) return WrongReason::chance;
    if (examination.mapIgnored) return WrongReason::mapIgnored;
    const Offence& inward = examination.conduct.inward;
    const RampKind kind = examination.ramps().kind;
    if (liesFlat(examination)) return WrongReason::normalMissing;
    // Wrong tangents tip a normal over here and there; then they are what is wrong.
    if (inward.count > 0.5 * inward.asked) return WrongReason::inward;
    if (tiltsWithoutSlope(examination)) return WrongReason::flatTilted;
    if (kind == RampKind::strangeParametrisation && !growsWithSlope(examination))
        return WrongReason::doesNotGrow;
    if (const auto reason = reasonOf(kind)) return reason;
    if (!hasSenses(kind)) return std::nullopt;
    if (const auto reason = findDisagreement(examination)) return reason;
    // What follows asks whether a submission that is right on ramps is right elsewhere, too.
    if (kind != RampKind::right) return std::nullopt;
    // Tangents of the texel's corner tip a very strong tilt over at the seam's step.
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
    // Downwards within 45 degrees of straight down.
    constexpr double kDownwards = -0.7;
    return examination.ramps().response.has_value() &&
           examination.ramps().fit->parametrisation.axis().y < kDownwards;
}

bool pointsInwards(const Examination& examination) {
    // Wrong tangents tip some normals over, and a turn to the camera half of them.
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
    // Answers that are missing or not finite explain anything odd.
    const bool incomplete = conduct.threw || conduct.notFinite;
    const bool inward = !incomplete && pointsInwards(examination);
    // Seen from inside, signs and the map's place are others than those that were written.
    if (inward) faults.push_back(Fault::wrong);
    const bool telling = !tiltsWithoutSlope(examination);
    if (const auto fault = faultOf(examination); fault && telling) faults.push_back(*fault);
    if (telling && standsOnItsHead(examination)) faults.push_back(Fault::upsideDown);
    if (!incomplete && !inward && findWrong(examination)) faults.push_back(Fault::wrong);
    return faults;
}

}  // namespace ticker::tasks::bump
