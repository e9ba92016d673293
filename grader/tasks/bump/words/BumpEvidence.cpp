#include <grader/tasks/bump/words/BumpEvidence.h>

#include <grader/tasks/bump/questions/Numbers.h>
#include <grader/tasks/bump/words/Phrases.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

namespace ticker::tasks::bump {
namespace {

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

void addParametrisation(Evidence& evidence, const ParametrisationFit& fit) {
    const Vector3& axis = fit.parametrisation.axis();
    evidence.emplace_back("topOfMap", std::vector<double>{axis.x, axis.y, axis.z});
    evidence.emplace_back("uFacingTheCamera", fit.parametrisation.u({0.0, 0.0, -1.0}));
    evidence.emplace_back("mirrored", fit.parametrisation.mirrored());
    evidence.emplace_back("strayShare", fit.strayShare);
}

void addRegions(Evidence& evidence, const std::string& name, const RegionShares& shares) {
    evidence.emplace_back(name + "AsOnRamps", shares.asOnRamps);
    evidence.emplace_back(name + "AsOnRampsInTheWorstRegion", shares.worst);
}

void addOffence(Evidence& evidence, const std::string& name, const Offence& offence) {
    if (!offence) return;
    evidence.emplace_back(name + "Points", offence.count);
    evidence.emplace_back(name + "Asked", offence.asked);
    evidence.emplace_back(name + "FirstAt", placeInWords(offence.direction));
}

}  // namespace

Evidence evidenceOf(const std::vector<Fault>& faults, const Examination& examination) {
    Evidence evidence;
    std::string also;
    for (std::size_t i = 1; i < faults.size(); ++i)
        also += (also.empty() ? "" : ", ") + std::string{textOf(faults[i]).id};
    if (!also.empty()) evidence.emplace_back("also", also);
    if (examination.letters) addLetters(evidence, *examination.letters);
    if (examination.ramps().response) {
        const ResponseMatrix& m = examination.ramps().response->matrix;
        evidence.emplace_back("responseMatrix",
                              std::vector<double>{m[0][0], m[0][1], m[1][0], m[1][1]});
        addAxis(evidence, "u", examination.ramps().response->u);
        addAxis(evidence, "v", examination.ramps().response->v);
    }
    if (examination.regions) {
        addRegions(evidence, "largeMapU", examination.regions->u);
        addRegions(evidence, "largeMapV", examination.regions->v);
    }
    if (examination.fineness) {
        evidence.emplace_back("finenessAlongU", examination.fineness->u);
        evidence.emplace_back("finenessAlongV", examination.fineness->v);
    }
    evidence.emplace_back("steepOverGentleSlopes", static_cast<double>(ProportionPlan::kTimes));
    evidence.emplace_back("steepOverGentleTilts", examination.proportion.growth);
    evidence.emplace_back("brightOverDarkTilts", examination.proportion.brightOverDark);
    evidence.emplace_back("greyOverDarkTilts", examination.proportion.middleOverDark);
    if (examination.edges) evidence.emplace_back("seamOverElsewhere", examination.edges->seam);
    if (examination.ramps().fit) addParametrisation(evidence, *examination.ramps().fit);
    addOffence(evidence, "exception", examination.conduct.threw);
    addOffence(evidence, "notFinite", examination.conduct.notFinite);
    addOffence(evidence, "notUnit", examination.conduct.notUnit);
    addOffence(evidence, "inward", examination.conduct.inward);
    evidence.emplace_back("largestTiltDegrees",
                          std::atan(examination.conduct.largestTilt) * kDegrees);
    return evidence;
}

}  // namespace ticker::tasks::bump
