#include <grader/build/Build.h>
#include <grader/lab/calibrate/Subject.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace ticker::calibrate {

namespace fs = std::filesystem;

bool Subject::isUnseen() const {
    return expect.names("shadow.unseen-rays") || expect.names("dof.unseen-rays") ||
           name.find("/unseen-") != std::string::npos ||
           name.find("/own-code-") != std::string::npos;
}

bool Subject::isStatistical() const {
    constexpr std::array kOfDistributions{"shadow.light-size", "shadow.not-a-ball",
                                          "dof.aperture-size", "dof.disc", "dof.off-centre"};
    return isUnseen() || std::any_of(kOfDistributions.begin(), kOfDistributions.end(),
                                     [&](const char* id) { return expect.names(id); });
}

bool isAmong(std::span<const std::string_view> names, const Subject& subject) {
    return std::ranges::find(names, subject.name) != names.end();
}

const SceneEntry& randomScene() {
    return *std::ranges::find_if(defaultExercise().scenes, [](const SceneEntry& scene) {
        return scene.isRandom && scene.isHandedIn;
    });
}

std::vector<Subject> readSubjects(const fs::path& data) {
    const std::string& file = randomScene().file;
    std::vector<Subject> subjects;
    for (const corpus::Entry& entry : corpus::readCatalogue(data))
        if (defaultExercise().fileOf(entry.group) == file)
            subjects.push_back({entry.group + "/" + entry.name, corpus::textsOf(entry).at(file),
                                entry.group, entry.expected(), file});
    for (const corpus::Entry& entry : corpus::readEntries(data, {"samples", "unseen"})) {
        if (entry.group != "awarded" && !entry.group.ends_with("/right")) continue;
        const std::map<std::string, std::string> texts = corpus::textsOf(entry);
        if (const auto text = texts.find(file); text != texts.end())
            subjects.push_back(
                {"right/" + entry.name, text->second, "", {{"passed"}, {{}}, false}, file});
    }
    std::sort(subjects.begin(), subjects.end(),
              [](const Subject& a, const Subject& b) { return a.name < b.name; });
    return subjects;
}

const build::Program& Programs::of(const Subject& subject) {
    Slot* slot = nullptr;
    {
        const std::lock_guard lock{mutex_};
        slot = &slots_[subject.name];
    }
    std::call_once(slot->once, [&] {
        build::BuildResult built =
            build::buildProgram(kit_, sandbox_, sandbox::Limits{}, subject.file, subject.source);
        if (!built.program)
            throw raytracer::Error(
                fmt::format("{} does not compile: {}", subject.name, built.diagnostics));
        slot->program = std::make_unique<build::Program>(std::move(*built.program));
    });
    return *slot->program;
}

}  // namespace ticker::calibrate
