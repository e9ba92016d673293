#include <grader/base/CpuTime.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/lab/calibrate/campaigns/ComparisonCampaign.h>
#include <grader/lab/calibrate/campaigns/ComparisonTables.h>
#include <grader/tasks/Tasks.h>

#include <raytracer/base/Error.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace ticker::calibrate {
namespace {

constexpr std::uint64_t kSeed = 20;

raytracer::RenderSettings smallPicture() {
    raytracer::RenderSettings settings;
    settings.width = 160;
    settings.height = 120;
    settings.seed = kSeed;
    return settings;
}

double rounded(double value) {
    return std::round(value * 1e5) / 1e5;
}

bool passes(const std::vector<TaskReport>& reports) {
    return std::ranges::all_of(
        reports, [](const TaskReport& report) { return report.state == TaskState::passed; });
}

}  // namespace

ComparisonCampaign::ComparisonCampaign(std::vector<Subject> subjects,
                                       raytracer::SceneDescription scene, Programs& programs)
    : subjects_(std::move(subjects)), scene_(std::move(scene)), programs_(programs) {}

const PictureMethods& ComparisonCampaign::methods() {
    std::call_once(once_,
                   [&] { methods_ = std::make_unique<PictureMethods>(scene_, smallPicture()); });
    return *methods_;
}

Campaign::Basis ComparisonCampaign::basisOf(std::size_t unit) const {
    const Subject& subject = subjects_.at(unit);
    std::vector<std::string> measured{"methods"};
    for (const TaskEntry& task : subject.exercise->tasks)
        if (task.file == subject.file) measured.push_back(task.id);
    return {measured, subject.name, subject.basis()};
}

std::vector<std::size_t> ComparisonCampaign::checkUnits() const {
    std::vector<std::size_t> units;
    for (std::size_t unit = 0; unit < subjects_.size(); ++unit)
        if (isAmong(kRightAndSmaller, subjects_[unit])) units.push_back(unit);
    return units;
}

bool ComparisonCampaign::agrees(const std::string& before, const std::string& now) const {
    constexpr double kShare = 0.01;
    const nlohmann::json then = nlohmann::json::parse(before);
    const nlohmann::json again = nlohmann::json::parse(now);
    const auto same = [&](const char* name) { return then.at(name) == again.at(name); };
    const auto near = [&](const char* name) {
        const auto was = then.at(name).get<double>();
        return std::abs(again.at(name).get<double>() - was) <= kShare * was;
    };
    return same("subject") && same("right") && same("ours") && near("rmse") && near("ssim") &&
           near("flip") && near("zTest");
}

std::string ComparisonCampaign::run(std::size_t unit) {
    const Subject& subject = subjects_.at(unit);
    const sandbox::Limits limits;
    build::SandboxedExaminee examinee{programs_.of(subject), programs_.sandbox(), limits};
    const double before = threadCpuMs();
    probe::RenderQuestion question;
    question.scene = scene_;
    question.settings = smallPicture();
    const probe::Run run = examinee.ask({question});
    const auto* answer =
        run.answers.empty() ? nullptr : std::get_if<probe::RenderAnswer>(&run.answers[0]);
    if (answer == nullptr || answer->images.empty())
        throw raytracer::Error(subject.name + " gave no picture: " + run.end.detail);
    const PictureScores scores = methods().score(answer->images.front());
    const bool ours = passes(tasks::judgeFile(defaultExercise(), subject.file, examinee, kSeed));
    return nlohmann::json{{"subject", subject.name},
                          {"right", subject.isRight()},
                          {"ours", ours},
                          {"rmse", rounded(scores.rmse)},
                          {"ssim", rounded(scores.ssim)},
                          {"flip", rounded(scores.flip)},
                          {"zTest", rounded(scores.zTest)},
                          {"cpu", std::lround(threadCpuMs() - before + examinee.cpuMs())}}
        .dump();
}

Summary ComparisonCampaign::summarise(const std::vector<std::string>& records) const {
    return comparisonTables(records);
}

}  // namespace ticker::calibrate
