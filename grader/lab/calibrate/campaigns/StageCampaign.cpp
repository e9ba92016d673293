#include <grader/base/CpuTime.h>
#include <grader/build/SandboxedExaminee.h>
#include <grader/lab/calibrate/OwnNoise.h>
#include <grader/lab/calibrate/RateBounds.h>
#include <grader/lab/calibrate/Seed.h>
#include <grader/lab/calibrate/campaigns/StageCampaign.h>
#include <grader/tasks/lens/checks/PictureCheck.h>
#include <grader/tasks/lens/questions/PictureQuestions.h>
#include <grader/tasks/shadows/penumbra/PenumbraCheck.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <variant>

namespace ticker::calibrate {
namespace {

using nlohmann::json;

constexpr std::size_t kBlock = 10;

// Statistics are counted in hundredths.
constexpr double kHundred = 100.0;

struct Stage {
    bool failed = false;
    double statistic = 0.0;  // in units of the limit
};

template <class Answer>
Answer answerOf(probe::Examinee& examinee, const probe::Question& question) {
    const probe::Run run = examinee.ask({question});
    const auto* answer = run.answers.empty() ? nullptr : std::get_if<Answer>(&run.answers.front());
    if (answer == nullptr || answer->state != probe::AnswerState::answered)
        throw raytracer::Error("a right submission did not answer: " + run.end.detail);
    return *answer;
}

Stage shadowStage(probe::Examinee& examinee, tasks::PenumbraShelf& shelf, std::uint64_t seed) {
    const auto expectations = shelf.of(seed, seed);
    const tasks::PenumbraVerdict verdict = tasks::checkPenumbra(
        *expectations, answerOf<probe::IlluminateAnswer>(examinee, expectations->asked().question));
    const bool fails = verdict.finding && verdict.finding->severity == Severity::fail;
    return {fails || verdict.ambiguous, verdict.timesTheBound};
}

Stage pictureStage(probe::Examinee& examinee, tasks::ExpectationShelf& shelf, std::uint64_t seed) {
    const probe::RenderQuestion asked = tasks::drawPictureQuestion(seed);
    const tasks::PictureVerdict verdict = tasks::judgePictures(
        *tasks::expectationsOf(shelf, asked, seed), answerOf<probe::RenderAnswer>(examinee, asked));
    return {verdict.finding.has_value() || verdict.ambiguous, verdict.timesTheLimit};
}

/// All stages of one kind.
struct StageTally {
    std::size_t stages = 0;
    std::size_t failed = 0;
    std::map<int, std::size_t> statistics;

    [[nodiscard]] double quantile(double share) const {
        std::size_t below = 0;
        for (const auto& [hundredths, times] : statistics) {
            below += times;
            if (static_cast<double>(below) >= share * static_cast<double>(stages))
                return hundredths / kHundred;
        }
        return 0.0;
    }
    void add(const json& record) {
        stages += record.at("stages").get<std::size_t>();
        failed += record.at("failed").get<std::size_t>();
        for (const auto& [hundredths, times] : record.at("statistics").items())
            statistics[std::stoi(hundredths)] += times.get<std::size_t>();
    }
    [[nodiscard]] std::string line(const char* what) const {
        if (stages == 0) return "";
        return fmt::format(
            "| {} | {} | {} | {:.2g} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", what,
            stages, failed, upperBound(failed, stages), quantile(0.5), quantile(0.9),
            quantile(0.99), quantile(0.999), quantile(1.0));
    }
};

bool isSuited(const Subject& subject) {
    // Code with a fixed seed always gives the same sample of its noise and is judged in another
    // way.
    return subject.isRight() && subject.isUnseen() && !subject.task.empty() &&
           subject.name.find("fixed") == std::string::npos;
}

// Whether a subject is about the first task of its file, soft shadows; the others are judged by
// their pictures.
bool isOfFirstTask(const Subject& subject) {
    const auto first = std::ranges::find(defaultExercise().tasks, subject.file, &TaskEntry::file);
    return subject.task == first->id;
}

}  // namespace

StageCampaign::StageCampaign(const std::vector<Subject>& subjects, std::size_t units,
                             Programs& programs)
    : units_(units), programs_(programs) {
    for (const Subject& subject : subjects)
        if (isSuited(subject)) (isOfFirstTask(subject) ? shadows_ : pictures_).push_back(subject);
}

const Subject& StageCampaign::subjectOf(std::size_t unit) const {
    const std::vector<Subject>& subjects = unit % 2 == 1 ? pictures_ : shadows_;
    return subjects.at(unit / 2 % subjects.size());
}

std::string StageCampaign::unitName(std::size_t unit) const {
    const std::size_t subjects = unit % 2 == 1 ? pictures_.size() : shadows_.size();
    return fmt::format("{} {}", subjectOf(unit).name, unit / 2 / subjects);
}

// All subjects of a round are asked the same, each with random numbers of its own.
std::string StageCampaign::seedName(std::size_t unit) const {
    return unit % 2 == 1 ? fmt::format("pictures of round {}", unit / 2 / pictures_.size())
                         : fmt::format("stages of round {}", unit / 2 / shadows_.size());
}

Campaign::Basis StageCampaign::basisOf(std::size_t unit) const {
    const Subject& subject = subjectOf(unit);
    return {{subject.task}, subject.name, subject.basis()};
}

std::string StageCampaign::run(std::size_t unit) {
    const bool picture = unit % 2 == 1;
    const Subject& subject = subjectOf(unit);
    const build::Program& program = programs_.of(subject);
    const sandbox::Limits limits;
    build::SandboxedExaminee examinee{program, programs_.sandbox(), limits};
    OwnNoise noisy{examinee, seedOf(subject.name)};
    const double before = threadCpuMs();
    std::size_t failed = 0;
    std::map<std::string, std::size_t> statistics;
    for (std::size_t i = 0; i < kBlock; ++i) {
        const std::uint64_t seed = seedOf(seedName(unit)) + i;
        const Stage stage = picture ? pictureStage(noisy, pictureShelf_, seed)
                                    : shadowStage(noisy, penumbraShelf_, seed);
        if (stage.failed) ++failed;
        ++statistics[std::to_string(std::lround(stage.statistic * kHundred))];
    }
    return json{{"kind", picture ? "picture" : "shadow"},
                {"subject", subject.name},
                {"stages", kBlock},
                {"failed", failed},
                {"statistics", statistics},
                {"cpu", std::lround(threadCpuMs() - before + examinee.cpuMs())}}
        .dump();
}

// Statistics are not compared: their last digits differ between processors.
bool StageCampaign::agrees(const std::string& before, const std::string& now) const {
    const json then = json::parse(before);
    const json again = json::parse(now);
    const auto same = [&](const char* name) { return then.at(name) == again.at(name); };
    return same("kind") && same("subject") && same("stages") && same("failed");
}

Summary StageCampaign::summarise(const std::vector<std::string>& records) const {
    std::map<std::string, StageTally> kinds;
    StageTally all;
    for (const std::string& text : records) {
        const json record = json::parse(text);
        kinds[record.at("kind")].add(record);
        all.add(record);
    }
    // Largest rate of failures of one stage, as the error budget of two stages assumes.
    constexpr double kTail = 5e-4;
    Summary summary;
    summary.asExpected = upperBound(all.failed, all.stages) <= kTail;
    summary.text =
        "| stage | times | failed | 95 % bound | median | 90 % | 99 % | 99.9 % | most |\n"
        "|---|---|---|---|---|---|---|---|---|\n" +
        kinds["shadow"].line("values at shadows' edges") + kinds["picture"].line("pictures") +
        all.line("both");
    return summary;
}

}  // namespace ticker::calibrate
