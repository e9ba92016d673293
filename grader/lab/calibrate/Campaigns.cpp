#include <grader/exercise/Exercise.h>
#include <grader/lab/agreement/OracleAgreement.h>
#include <grader/lab/calibrate/Campaigns.h>
#include <grader/lab/calibrate/ComparisonCampaign.h>
#include <grader/lab/calibrate/DecisionCampaign.h>
#include <grader/lab/calibrate/PictureCampaign.h>
#include <grader/lab/calibrate/StageCampaign.h>

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

}  // namespace

std::vector<std::unique_ptr<Campaign>> campaigns(const std::filesystem::path& data,
                                                 Programs& programs) {
    // A decision on code whose rays are not visible takes ten times as long.
    const auto timesRight = [](const Subject& subject) -> std::size_t {
        return subject.isUnseen() ? 150 : 350;
    };
    const auto timesWrong = [](const Subject& subject) -> std::size_t {
        return !subject.isStatistical() || subject.isUnseen() ? 100 : 1000;
    };
    constexpr std::size_t kStageUnits = 300;
    constexpr int kAgreementRounds = 10;
    const std::vector<Subject> subjects = readSubjects(data);
    std::vector<std::unique_ptr<Campaign>> all;
    all.push_back(
        std::make_unique<DecisionCampaign>("correct", rightOnes(subjects), timesRight, programs));
    all.push_back(std::make_unique<StageCampaign>(subjects, kStageUnits, programs));
    all.push_back(
        std::make_unique<DecisionCampaign>("mistakes", wrongOnes(subjects), timesWrong, programs));
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
