#include <grader/tasks/bump/words/Diagnosis.h>

#include <algorithm>
#include <array>
#include <span>

namespace ticker::tasks::bump {
namespace {

// A tilt of a thousandth changes no pixel by a grey step, not even at an edge from black to white.
constexpr double kVisibleTilt = 1e-3;

/// What ramps of one kind show: a fault, or a reason of Fault::wrong. A sign is named only if every
/// map agrees: an inversion in some rows or greys alone is not a matter of one sign.
struct KindRow {
    RampKind kind;
    std::optional<Fault> fault;
    std::optional<WrongReason> reason;
    bool mustAgree = false;
};

constexpr std::array kKinds{
    KindRow{RampKind::longitudeDependent, Fault::longitudeDependent, {}},
    KindRow{RampKind::swapped, Fault::swapped, {}},
    KindRow{RampKind::inverted, Fault::inverted, {}, true},
    KindRow{RampKind::invertedU, Fault::invertedU, {}, true},
    KindRow{RampKind::invertedV, Fault::invertedV, {}, true},
    KindRow{RampKind::silent, {}, WrongReason::smallSlopesLost},
    KindRow{RampKind::slopeUIgnored, {}, WrongReason::slopeUIgnored},
    KindRow{RampKind::slopeVIgnored, {}, WrongReason::slopeVIgnored},
    KindRow{RampKind::signLost, {}, WrongReason::signLost},
    KindRow{RampKind::strangeParametrisation, {}, WrongReason::strangeParametrisation},
    KindRow{RampKind::patchy, {}, WrongReason::patchy},
    KindRow{RampKind::strangeDirection, {}, WrongReason::strangeDirection},
};

/// The row of the examination's ramps; one without fault and reason if they have none.
KindRow rowOf(const Examination& examination) {
    const RampKind kind = examination.ramps().kind;
    const auto* const row = std::ranges::find(kKinds, kind, &KindRow::kind);
    return row == kKinds.end() ? KindRow{kind, {}, {}} : *row;
}

std::optional<Fault> faultOf(const Examination& examination) {
    const KindRow row = rowOf(examination);
    return row.mustAgree && !examination.agreesWithRamps() ? std::nullopt : row.fault;
}

bool isFlat(const Examination& examination) {
    const Conduct& conduct = examination.conduct;
    return !conduct.inward && !conduct.threw && !conduct.notFinite &&
           !(conduct.largestTilt > kVisibleTilt);
}

/// True if a flat map tilts the normal. What ramps change then proves nothing.
bool tiltsWithoutSlope(const Examination& examination) {
    // Normals of chords over a hundredth of the map lean by 0.03; smaller tilts are subtracted.
    constexpr double kFlatTilt = 0.1;
    return examination.ladder.flatTilt > kFlatTilt;
}

/// True if the normals of the ramps lie flat in the surface. Any strength of the tilt is accepted
/// that leaves some part along the smooth normal: a strength of 20 leaves 0.001 on these ramps.
bool liesFlat(const Examination& examination) {
    constexpr double kFlat = 1e3;
    const RampStrength& strength = examination.ramps().strength;
    return std::max(strength.alongU, strength.alongV) > kFlat;
}

bool growsWithSlope(const Examination& examination) {
    return examination.ladder.growsWithSlope && examination.proportion.good();
}

/// True if each axis has one sense on the ramps, right or inverted.
bool hasSenses(RampKind kind) {
    return kind == RampKind::right || kind == RampKind::inverted || kind == RampKind::invertedU ||
           kind == RampKind::invertedV;
}

/// True if many points share their normal. Right code gives no normal at two points, unless it
/// keeps tables of angles, and then each axis keeps one sense on the ramps.
bool roundsNormals(const Examination& examination) {
    constexpr double kMany = 0.1;
    return !hasSenses(examination.ramps().kind) && examination.ladder.sharedNormals > kMany;
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

/// One reason of Fault::wrong.
struct Rule {
    WrongReason reason;
    bool (*applies)(const Examination& examination);
};

// Half a degree; observed changes are larger.
constexpr double kSomeChange = 0.01;
constexpr double kSomePoints = 0.01;  // of all that were asked for; right code gives none

bool pointInwards(const Examination& examination, double share) {
    const Offence& inward = examination.conduct.inward;
    return inward.count > share * inward.asked;
}

/// The reasons that apply whatever the ramps show.
constexpr std::array kAnyRamps{
    Rule{WrongReason::chance, [](const Examination& e) { return e.conduct.chance > kSomeChange; }},
    Rule{WrongReason::mapIgnored, [](const Examination& e) { return e.mapIgnored; }},
    Rule{WrongReason::normalMissing, liesFlat},
    // Wrong tangents turn a few normals inwards; the tangents are then the fault.
    Rule{WrongReason::inward, [](const Examination& e) { return pointInwards(e, 0.5); }},
    Rule{WrongReason::flatTilted, tiltsWithoutSlope},
    Rule{WrongReason::normalsRounded, roundsNormals},
    Rule{WrongReason::doesNotGrow,
         [](const Examination& e) {
             return e.ramps().kind == RampKind::strangeParametrisation && !growsWithSlope(e);
         }},
};

/// The reasons of submissions that are right on ramps.
constexpr std::array kRightRamps{
    // Tangents at the texel's corner turn a very strong tilt inwards at the seam's step.
    Rule{WrongReason::inward, [](const Examination& e) { return pointInwards(e, 0.01); }},
    Rule{WrongReason::doesNotGrow, [](const Examination& e) { return !growsWithSlope(e); }},
    Rule{WrongReason::heightsBent,
         [](const Examination& e) { return !e.proportion.isSameAtEveryHeight(); }},
    Rule{WrongReason::pastHorizon,
         [](const Examination& e) { return !e.proportion.staysAboveHorizon(); }},
    Rule{WrongReason::dependsOnOrder,
         [](const Examination& e) { return e.changedByOrder > kSomePoints; }},
    Rule{WrongReason::remembers,
         [](const Examination& e) { return e.conduct.memory > kSomeChange; }},
    Rule{WrongReason::wallAtSeam,
         [](const Examination& e) { return e.edges && !e.edges->goodSeam(); }},
    // This rule comes before `coordinatesRounded`: slopes that lose a step make pairs of the zigzag
    // equal, too, while rounded coordinates leave rises and falls in balance.
    Rule{WrongReason::stepsLost,
         [](const Examination& e) { return e.balance && !e.balance->good(); }},
    Rule{WrongReason::coordinatesRounded,
         [](const Examination& e) { return e.fineness && !e.fineness->good(); }},
    Rule{WrongReason::fractionsMixed,
         [](const Examination& e) { return e.stripes && !e.stripes->good(); }},
    Rule{WrongReason::lettersDiffer,
         [](const Examination& e) { return !e.letters || !e.letters->good(); }},
    Rule{WrongReason::dependsOnEye, [](const Examination& e) { return !e.elsewhere.good(); }},
    Rule{WrongReason::turnedAtPoles,
         [](const Examination& e) { return e.caps && !e.caps->good(); }},
    Rule{WrongReason::fewTexelsDiffer,
         [](const Examination& e) { return e.fewTexels && !e.fewTexels->good(); }},
    Rule{WrongReason::stepsUneven,
         [](const Examination& e) { return e.evenSteps && !e.evenSteps->good(); }},
    Rule{WrongReason::sharpStepsTurned, [](const Examination& e) { return !e.sharpSteps.good(); }},
    Rule{WrongReason::besidePlanes,
         [](const Examination& e) { return e.belts && !e.belts->good(); }},
    // This rule comes before `smallSphereDiffers`: the small sphere's waves are short, so that the
    // slope of a column some way off is another one there first.
    Rule{WrongReason::otherTexels,
         [](const Examination& e) { return e.ownTexels && !e.ownTexels->good(); }},
    Rule{WrongReason::smallSphereDiffers,
         [](const Examination& e) { return e.slopes && !e.slopes->smallAgrees(); }},
    Rule{WrongReason::smoothInPlaces, [](const Examination& e) { return !e.untilted.good(); }},
};

std::optional<WrongReason> firstOf(std::span<const Rule> rules, const Examination& examination) {
    for (const Rule& rule : rules)
        if (rule.applies(examination)) return rule.reason;
    return std::nullopt;
}

}  // namespace

std::optional<WrongReason> findWrong(const Examination& examination) {
    if (const auto reason = firstOf(kAnyRamps, examination)) return reason;
    const KindRow row = rowOf(examination);
    // The code keeps slopes from an earlier, flat map of the same size.
    if (row.kind == RampKind::silent && examination.conduct.sameOnOtherMap)
        return WrongReason::mapIgnored;
    if (row.reason) return row.reason;
    if (!hasSenses(row.kind)) return std::nullopt;
    if (const auto reason = findDisagreement(examination)) return reason;
    return row.kind == RampKind::right ? firstOf(kRightRamps, examination) : std::nullopt;
}

bool isTransposed(const Examination& examination, const std::optional<Hints>& hints) {
    const bool unclear = !examination.ramps().response;
    return unclear && (examination.ramps().transposed || (hints && hints->square.transposed));
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

Diagnosis diagnose(const Examination& examination, const std::optional<Hints>& hints) {
    if (isTransposed(examination, hints)) return {{Fault::swapped}, {}};
    Diagnosis diagnosis;
    std::vector<Fault>& faults = diagnosis.faults;
    const Conduct& conduct = examination.conduct;
    if (conduct.threw) faults.push_back(Fault::threw);
    if (conduct.notFinite) faults.push_back(Fault::notFinite);
    if (conduct.notUnit) faults.push_back(Fault::notUnit);
    if (isFlat(examination)) {
        faults.push_back(Fault::flat);
        return diagnosis;
    }
    // Missing answers and answers that are not finite explain all other oddities.
    const bool incomplete = conduct.threw || conduct.notFinite;
    if (!incomplete) diagnosis.wrong = findWrong(examination);
    const bool inward = !incomplete && pointsInwards(examination);
    // Seen from inside, signs and the map's place differ from those in the code.
    if (inward) faults.push_back(Fault::wrong);
    const bool telling = !tiltsWithoutSlope(examination);
    if (const auto fault = faultOf(examination); fault && telling) faults.push_back(*fault);
    if (telling && standsOnItsHead(examination)) faults.push_back(Fault::upsideDown);
    if (!inward && diagnosis.wrong) faults.push_back(Fault::wrong);
    return diagnosis;
}

}  // namespace ticker::tasks::bump
