#include <grader/build/Build.h>
#include <grader/lab/calibrate/CodeOnly.h>
#include <grader/lab/calibrate/Subject.h>
#include <grader/tasks/lens/LensFindings.h>
#include <grader/tasks/shadows/ShadowFindings.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

namespace ticker::calibrate {

namespace fs = std::filesystem;

bool Subject::isUnseen() const {
    return expect.names(tasks::kShadowUnseenRays.id) || expect.names(tasks::kDofUnseenRays.id) ||
           name.find("/unseen-") != std::string::npos ||
           name.find("/own-code-") != std::string::npos;
}

bool Subject::isStatistical() const {
    constexpr std::array kOfDistributions{&tasks::kShadowLightSize, &tasks::kShadowNotABall,
                                          &tasks::kDofApertureSize, &tasks::kDofDisc,
                                          &tasks::kDofOffCentre};
    return isUnseen() ||
           std::any_of(kOfDistributions.begin(), kOfDistributions.end(),
                       [&](const FindingText* text) { return expect.names(text->id); });
}

bool Subject::isDataRace() const {
    return expect.names(tasks::kShadowThreadsMixed.id) || expect.names(tasks::kDofThreadsMixed.id);
}

std::string Subject::ownTask() const {
    return task.empty() ? std::ranges::find(exercise->tasks, file, &TaskEntry::file)->id : task;
}

std::string Subject::basis() const {
    std::string text = codeOnly(source);
    for (const std::string& state : expect.states)
        text += "\n" + state;
    for (const std::string& finding : expect.findings.value_or(std::vector<std::string>{"any"}))
        text += "\n" + finding;
    return text + (expect.needsReview ? "\nreview" : "");
}

bool isAmong(std::span<const std::string_view> names, const Subject& subject) {
    return std::ranges::find(names, subject.name) != names.end();
}

const SceneEntry& randomScene() {
    return *std::ranges::find_if(defaultExercise().scenes, [](const SceneEntry& scene) {
        return scene.isRandom && scene.isHandedIn;
    });
}

namespace {

bool isFileOf(const Exercise& exercise, const std::string& file) {
    return std::ranges::find(exercise.tasks, file, &TaskEntry::file) != exercise.tasks.end();
}

// The subjects of the files that `isWanted` accepts.
std::vector<Subject> subjectsOf(const fs::path& data, const Exercise& exercise,
                                const std::function<bool(std::string_view file)>& isWanted) {
    std::vector<Subject> subjects;
    for (const corpus::Entry& entry : corpus::readCatalogue(data, exercise))
        if (const std::string file{exercise.fileOf(entry.group)}; isWanted(file))
            subjects.push_back({entry.group + "/" + entry.name, corpus::textsOf(entry).at(file),
                                entry.group, entry.expected(), file, &exercise});
    for (const corpus::Entry& entry : corpus::readEntries(data, {"samples", "unseen"}, exercise)) {
        if (entry.group != "awarded" && !entry.group.ends_with("/right")) continue;
        for (const auto& [file, text] : corpus::textsOf(entry))
            if (isWanted(file) && isFileOf(exercise, file))
                subjects.push_back(
                    {"right/" + entry.name, text, "", {{"passed"}, {{}}, false}, file, &exercise});
    }
    std::ranges::sort(subjects, {}, &Subject::name);
    return subjects;
}

}  // namespace

std::vector<Subject> readSubjects(const fs::path& data) {
    return subjectsOf(data, defaultExercise(),
                      [](std::string_view file) { return file == randomScene().file; });
}

std::vector<Subject> readExactSubjects(const fs::path& data) {
    std::vector<Subject> all;
    for (const Exercise& exercise : knownExercises()) {
        const bool isDefault = exercise.name == defaultExercise().name;
        for (Subject& subject : subjectsOf(data, exercise, [&](std::string_view file) {
                 return !isDefault || file != randomScene().file;
             })) {
            subject.name = exercise.name + ":" + subject.name;
            if (subject.task.empty()) subject.name += "/" + subject.file;
            all.push_back(std::move(subject));
        }
    }
    return all;
}

Programs::Programs(const sandbox::Sandbox& sandbox) : sandbox_(sandbox) {
    for (const Exercise& exercise : knownExercises())
        kits_.emplace(exercise.name, build::Kit::besideProgram(exercise));
}

const build::Program& Programs::of(const Subject& subject) {
    Slot* slot = nullptr;
    {
        const std::lock_guard lock{mutex_};
        slot = &slots_[subject.name];
    }
    std::call_once(slot->once, [&] {
        build::BuildResult built = build::buildProgram(
            kit(*subject.exercise), sandbox_, sandbox::Limits{}, subject.file, subject.source);
        if (!built.program)
            throw raytracer::Error(
                fmt::format("{} does not compile: {}", subject.name, built.diagnostics));
        slot->program = std::make_unique<build::Program>(std::move(*built.program));
    });
    return *slot->program;
}

}  // namespace ticker::calibrate
