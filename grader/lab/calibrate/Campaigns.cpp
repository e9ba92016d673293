#include <grader/exercise/Exercise.h>
#include <grader/lab/agreement/OracleAgreement.h>
#include <grader/lab/calibrate/Campaigns.h>
#include <grader/lab/calibrate/campaigns/ComparisonCampaign.h>
#include <grader/lab/calibrate/campaigns/DecisionCampaign.h>
#include <grader/lab/calibrate/campaigns/DecisionTables.h>
#include <grader/lab/calibrate/campaigns/PictureCampaign.h>
#include <grader/lab/calibrate/campaigns/StageCampaign.h>

#include <raytracer/io/SceneReader.h>

#include <string>
#include <utility>
#include <vector>

namespace ticker::calibrate {
namespace {

/// The scenes of all exercises but the default one, by name.
std::vector<std::string> scenesOfOthers() {
    std::vector<std::string> names;
    for (const Exercise& exercise : knownExercises())
        if (exercise.name != defaultExercise().name)
            for (const SceneEntry& scene : exercise.scenes)
                names.push_back(scene.name);
    return names;
}

// Numbers of decisions on a subject. On code whose rays are not visible, one takes ten times as
// long.
std::size_t timesRight(const Subject& subject) {
    return subject.isUnseen() ? 150 : 350;
}

std::size_t timesWrong(const Subject& subject) {
    return !subject.isStatistical() || subject.isUnseen() ? 100 : 1000;
}

// A verdict is exact for each scene; chance decides which scenes are asked about.
constexpr std::size_t kExactBlock = 20;
std::size_t timesExact(const Subject& subject) {
    return subject.isRight() ? 7 * kExactBlock : kExactBlock;
}

using Campaigns = std::vector<std::unique_ptr<Campaign>>;

void addDecisions(Campaigns& all, DecisionPlan plan, Programs& programs) {
    all.push_back(std::make_unique<DecisionCampaign>(std::move(plan), programs));
}

}  // namespace

Campaigns campaigns(const std::filesystem::path& data, Programs& programs) {
    constexpr std::size_t kBlock = 50;
    constexpr std::size_t kStageUnits = 300;
    constexpr int kAgreementRounds = 10;
    const std::vector<Subject> subjects = readSubjects(data);
    const std::vector<std::string_view> quick{kQuick.begin(), kQuick.end()};
    Campaigns all;
    addDecisions(all, {"correct", rightOnes(subjects), timesRight, kBlock, true, quick, tablesOf},
                 programs);
    all.push_back(std::make_unique<StageCampaign>(subjects, kStageUnits, programs));
    addDecisions(all, {"mistakes", wrongOnes(subjects), timesWrong, kBlock, true, quick, tablesOf},
                 programs);
    addDecisions(all,
                 {"exact",
                  readExactSubjects(data),
                  timesExact,
                  kExactBlock,
                  false,
                  {kQuickExact.begin(), kQuickExact.end()},
                  exactTables},
                 programs);
    all.push_back(std::make_unique<PictureCampaign>(
        subjects, pipeline::readSpecScenes(data / "scenes", data / "assets").back(), programs));
    all.push_back(std::make_unique<ComparisonCampaign>(
        subjects,
        raytracer::readScene(data / "scenes" / (randomScene().name + ".xml"), data / "assets"),
        programs));
    AgreementPlan plan{data / "scenes",
                       data / "assets",
                       data / defaultExercise().reference,
                       agreementCases(corpus::readCatalogue(data)),
                       scenesOfOthers(),
                       kAgreementRounds};
    all.push_back(
        std::make_unique<OracleAgreement>(std::move(plan), programs.kit(), programs.sandbox()));
    return all;
}

}  // namespace ticker::calibrate
