#include <grader/pipeline/Screenshot.h>

#include <grader/build/SandboxedExaminee.h>
#include <grader/metrics/Alignment.h>
#include <grader/picture/EncodePicture.h>
#include <grader/probe/Wire.h>
#include <grader/tasks/screenshot/JudgeScreenshot.h>
#include <grader/tasks/screenshot/ScreenshotFindings.h>
#include <grader/tasks/screenshot/UnlikeItself.h>
#include <grader/tasks/screenshot/Windows.h>

#include <raytracer/io/ImageReader.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

namespace ticker::pipeline {
namespace {

using raytracer::ByteImage;
using tasks::screenshot::Scene;

Finding finding(const FindingText& text, std::string message, std::string hint) {
    Finding result;
    result.id = text.id;
    result.severity = Severity::fail;
    result.message = std::move(message);
    result.hint = std::move(hint);
    result.section = "Test and submit";
    return result;
}

void fail(TaskReport& report, Finding finding) {
    settle(report, {TaskState::failed, "", {std::move(finding)}, false});
}

Finding unreadable(const picture::DecodeFailure& failure) {
    return finding(tasks::kScreenshotUnreadable,
                   fmt::format("screenshot.png cannot be read: {}.", failure.message),
                   "Hand in the file that tick1star -o screenshot.png writes.");
}

// Adds the picture to the report, at most 1280 pixels wide.
void show(const ByteImage& image, SubmissionResult& result) {
    constexpr int kWidest = 1280;
    ByteImage shown = image;
    if (image.width > kWidest) {
        const double scale = 1.0 * kWidest / image.width;
        const int height = std::max(1, static_cast<int>(std::lround(scale * image.height)));
        metrics::Picture smaller = metrics::resized(metrics::viewOf(image), kWidest, height);
        shown = {smaller.width, smaller.height, std::move(smaller.rgb)};
    }
    result.pictures.push_back(
        {"images/screenshot.png", "screenshot.png as handed in", picture::encodePicture(shown)});
}

/// Asks a program. If the questions are those of a run that was made ahead, it gives that run's
/// answers.
class WithAhead final : public probe::Examinee {
public:
    WithAhead(const JudgedFile& file, const Grader& grader, build::TimeBudget& budget)
        : program_(*file.program, grader.sandbox, grader.policy.run, &budget),
          ahead_(file.ahead ? &*file.ahead : nullptr) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        if (ahead_ == nullptr || probe::encodeQuestions(questions) != ahead_->questions)
            return program_.ask(questions);
        wallMs_ += ahead_->wallMs;
        madeForbiddenCall_ = madeForbiddenCall_ || ahead_->madeForbiddenCall;
        // Only once: if the judgement repeats a question, it wants to see whether the answer
        // repeats.
        return std::exchange(ahead_, nullptr)->run;
    }

    [[nodiscard]] double wallMs() const { return wallMs_ + program_.wallMs(); }
    [[nodiscard]] bool madeForbiddenCall() const {
        return madeForbiddenCall_ || program_.madeForbiddenCall();
    }

private:
    build::SandboxedExaminee program_;
    const AskedAhead* ahead_;
    double wallMs_ = 0.0;
    bool madeForbiddenCall_ = false;
};

/// The scenes that a picture may show, with the renders by the submission's files.
class Scenes {
public:
    Scenes(const std::vector<JudgedFile>& files, const Grader& grader, build::TimeBudget& budget,
           const std::vector<TaskReport>& tasks) {
        const bool any = std::ranges::any_of(files, &JudgedFile::isAttempted);
        const bool both = std::ranges::all_of(files, &JudgedFile::isAttempted);
        for (const SpecScene& spec : grader.scenes) {
            const auto file = std::ranges::find(files, spec.file, &JudgedFile::file);
            Scene scene;
            scene.name = spec.name;
            scene.file = spec.file;
            scene.isRandom = spec.isRandom;
            scene.isWanted =
                spec.isHandedIn && (!any || (file != files.end() && file->isAttempted));
            scene.mayMixBoth = both && !spec.isRandom;
            scene.description = &spec.scene;
            scene.expected = [&spec] { return metrics::viewOf(spec.expected().picture); };
            if (file != files.end()) addOwn(*file, grader, budget, scene);
            if (spec.isRandom) scene.whyUnlikeItself = tasks::whyUnlikeItself(tasks);
            scenes_.push_back(std::move(scene));
        }
    }

    [[nodiscard]] const std::vector<Scene>& all() const { return scenes_; }
    [[nodiscard]] double wallMs() const {
        double sum = 0.0;
        for (const auto& examinee : examinees_)
            sum += examinee->wallMs();
        return sum;
    }

    [[nodiscard]] bool madeForbiddenCall() const {
        return std::ranges::any_of(
            examinees_, [](const auto& examinee) { return examinee->madeForbiddenCall(); });
    }

private:
    void addOwn(const JudgedFile& file, const Grader& grader, build::TimeBudget& budget,
                Scene& scene) {
        const auto render = std::ranges::find(file.renders, scene.name, &Rendered::scene);
        if (render != file.renders.end()) scene.own = metrics::viewOf(render->picture);
        if (!file.program) return;
        examinees_.push_back(std::make_unique<WithAhead>(file, grader, budget));
        scene.examinee = examinees_.back().get();
    }

    std::vector<Scene> scenes_;
    std::vector<std::unique_ptr<WithAhead>> examinees_;
};

}  // namespace

std::vector<probe::Question> firstQuestions(const intake::Submission& submission,
                                            const std::string& file, const Grader& grader,
                                            std::uint64_t seed) {
    const auto isThere = [&](const std::string& part) { return submission.part(part).has_value(); };
    if (std::ranges::count_if(grader.exercise->files(), isThere) != 1) return {};
    const SpecScene* shown = nullptr;
    for (const SpecScene& scene : grader.scenes) {
        if (scene.file != file || !scene.isHandedIn) continue;
        if (shown != nullptr) return {};
        shown = &scene;
    }
    const auto& picture = submission.part(kScreenshotPart);
    if (shown == nullptr || !picture) return {};
    const auto size = picture::claimedSize(*picture).value_or(picture::PictureSize{});
    if (std::max(size.width, size.height) > picture::kLargestSide) return {};
    const int width = static_cast<int>(size.width);
    const int height = static_cast<int>(size.height);
    return tasks::screenshot::isSensibleSize(width, height)
               ? tasks::screenshot::firstQuestions(shown->scene, shown->isRandom, width, height,
                                                   seed)
               : std::vector<probe::Question>{};
}

AskedAhead askAhead(const std::vector<probe::Question>& questions, const build::Program& program,
                    const Grader& grader, build::TimeBudget& budget) {
    build::SandboxedExaminee examinee{program, grader.sandbox, grader.policy.run, &budget};
    AskedAhead ahead{probe::encodeQuestions(questions), examinee.ask(questions), 0.0, false};
    ahead.wallMs = examinee.wallMs();
    ahead.madeForbiddenCall = examinee.madeForbiddenCall();
    return ahead;
}

std::future<picture::Decoded> beginDecoding(const std::optional<std::string>& bytes,
                                            const Grader& grader) {
    if (!bytes) return {};
    return std::async(grader.isAlone ? std::launch::async : std::launch::deferred, [&] {
        return picture::decodePicture(*bytes, grader.sandbox, grader.policy.decode);
    });
}

TaskReport judgeScreenshotFile(std::future<picture::Decoded> picture,
                               const std::vector<JudgedFile>& files, const Grader& grader,
                               build::TimeBudget& budget, std::uint64_t seed,
                               SubmissionResult& result) {
    TaskReport report = blankReport(std::string{kScreenshotTask}, *grader.exercise);
    if (!picture.valid()) {
        fail(report, finding(tasks::kScreenshotMissing, "There is no screenshot.png.",
                             "Render your option's scene with tick1star and hand the picture in."));
        return report;
    }
    const picture::Decoded decoded = picture.get();
    if (const auto* failure = std::get_if<picture::DecodeFailure>(&decoded)) {
        fail(report, unreadable(*failure));
        return report;
    }
    const ByteImage& image = std::get<ByteImage>(decoded);
    show(image, result);
    const Scenes scenes{files, grader, budget, result.tasks};
    settle(report, tasks::judgeScreenshot(metrics::viewOf(image), scenes.all(), seed));
    result.timing.probeMs += scenes.wallMs();
    if (scenes.madeForbiddenCall()) {
        const Finding call = forbiddenCallFinding();
        settle(report, {TaskState::blocked, call.message, {call}, true});
    }
    return report;
}

}  // namespace ticker::pipeline
