#include <grader/base/CpuTime.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/lab/calibrate/RateBounds.h>
#include <grader/lab/calibrate/Seed.h>
#include <grader/lab/calibrate/campaigns/PictureCampaign.h>
#include <grader/pipeline/Fit.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/lens/checks/PictureDoubt.h>
#include <grader/tasks/shadows/ShadowFindings.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

namespace ticker::calibrate {
namespace {

using nlohmann::json;

constexpr std::uint64_t kRendersPerUnit = 10;

// Whether the campaign measures a right subject's pictures. It leaves out those that a warning
// explains, and those whose pixels share lens points, since their noise cannot be measured.
bool isCompared(const Subject& subject) {
    constexpr std::array kOthers{&tasks::kShadowViewFromEye, &tasks::kShadowNearSideFalloff,
                                 &tasks::kDofAntialiased, &tasks::kShadowFixedSamples,
                                 &tasks::kDofReusedPattern};
    return !isAmong(kOtherPictures, subject) &&
           std::ranges::none_of(kOthers, [&](const FindingText* text) {
               return text->id == subject.expect.finding();
           });
}

double smallestOf(const std::vector<Misfit>& misfits) {
    return std::ranges::min_element(misfits, {}, &Misfit::meanSquare)->meanSquare;
}

/// Renders of one kind of subject.
struct PictureTally {
    std::vector<double> misfits;

    void add(const json& record) {
        for (const json& misfit : record.at("misfits"))
            misfits.push_back(misfit.get<double>());
    }
    [[nodiscard]] std::size_t doubted() const {
        return static_cast<std::size_t>(std::ranges::count_if(
            misfits, [](double misfit) { return misfit > tasks::kMostMisfit; }));
    }
    [[nodiscard]] std::string line(const std::string& what) {
        if (misfits.empty()) return "";
        std::ranges::sort(misfits);
        return fmt::format("| {} | {} | {} | {:.2g} | {:.2f} | {:.2f} | {:.2f} |\n", what,
                           misfits.size(), doubted(), upperBound(doubted(), misfits.size()),
                           misfits.front(), misfits[misfits.size() / 2], misfits.back());
    }
};

}  // namespace

PictureCampaign::PictureCampaign(const std::vector<Subject>& subjects, pipeline::SpecScene scene,
                                 Programs& programs)
    : scene_(std::move(scene)), programs_(programs) {
    for (const Subject& subject : subjects)
        if ((subject.isRight() && isCompared(subject)) || isAmong(kSeenInPictures, subject) ||
            isAmong(kMeasuredInPictures, subject))
            subjects_.push_back(subject);
}

Campaign::Basis PictureCampaign::basisOf(std::size_t unit) const {
    const Subject& subject = subjects_.at(unit);
    return {{"pictures"}, subject.name, subject.basis()};
}

std::vector<std::size_t> PictureCampaign::checkUnits() const {
    std::vector<std::size_t> units;
    for (std::size_t unit = 0; unit < subjects_.size(); ++unit)
        if (isAmong(kRightAndHard, subjects_[unit])) units.push_back(unit);
    return units;
}

std::string PictureCampaign::run(std::size_t unit) {
    const Subject& subject = subjects_.at(unit);
    const sandbox::Limits limits;
    build::SandboxedExaminee examinee{programs_.of(subject), programs_.sandbox(), limits};
    const double before = threadCpuMs();
    std::vector<double> misfits;
    for (std::uint64_t i = 0; i < kRendersPerUnit; ++i) {
        raytracer::RenderSettings settings = scene_.settings;
        settings.seed = seedOf("picture " + subject.name) + i;
        const probe::Run run = examinee.ask({probe::RenderQuestion{scene_.scene, settings, 1, 0}});
        const auto& answer = std::get<probe::RenderAnswer>(run.answers.at(0));
        if (answer.state != probe::AnswerState::answered || answer.images.empty())
            throw raytracer::Error(subject.name + " gave no picture: " + run.end.detail);
        misfits.push_back(
            std::round(
                1e4 *
                smallestOf(pipeline::bestFit(scene_, answer, pipeline::Rays::handout).misfits)) /
            1e4);
    }
    return json{{"subject", subject.name},
                {"right", subject.isRight()},
                {"misfits", misfits},
                {"cpu", std::lround(threadCpuMs() - before + examinee.cpuMs())}}
        .dump();
}

// Renders with the kit's generator differ in their last digits between processors.
bool PictureCampaign::agrees(const std::string& before, const std::string& now) const {
    constexpr double kShare = 0.01;
    const json then = json::parse(before).at("misfits");
    const json again = json::parse(now).at("misfits");
    return then.size() == again.size() &&
           std::equal(then.begin(), then.end(), again.begin(), [](const json& a, const json& b) {
               return std::abs(a.get<double>() - b.get<double>()) <= kShare * a.get<double>();
           });
}

Summary PictureCampaign::summarise(const std::vector<std::string>& records) const {
    PictureTally right;
    std::string others;
    Summary summary;
    for (const std::string& text : records) {
        const json record = json::parse(text);
        if (record.at("right").get<bool>()) {
            right.add(record);
            continue;
        }
        PictureTally wrong;
        wrong.add(record);
        const auto name = record.at("subject").get<std::string>();
        others += wrong.line(name);
        if (std::ranges::find(kSeenInPictures, name) != kSeenInPictures.end())
            summary.asExpected = summary.asExpected && wrong.doubted() == wrong.misfits.size();
    }
    summary.asExpected = summary.asExpected && right.doubted() == 0;
    summary.text = fmt::format(
                       "| pictures of | renders | above {} | 95 % bound | least | median | most |\n"
                       "|---|---|---|---|---|---|---|\n",
                       tasks::kMostMisfit) +
                   right.line("right ones") + others;
    return summary;
}

}  // namespace ticker::calibrate
