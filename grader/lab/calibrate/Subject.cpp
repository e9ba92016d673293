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

std::vector<Subject> readSubjects(const fs::path& data) {
    std::vector<Subject> subjects;
    for (const corpus::Entry& entry : corpus::readCatalogue(data))
        if (entry.group.starts_with("T2."))
            subjects.push_back({entry.group + "/" + entry.name,
                                corpus::textsOf(entry).at(entry.file()), entry.group,
                                entry.expected()});
    for (const corpus::Entry& entry : corpus::readEntries(data, {"samples", "unseen"})) {
        if (entry.group != "awarded" && entry.group != "T2/right") continue;
        const std::map<std::string, std::string> texts = corpus::textsOf(entry);
        if (const auto text = texts.find("Renderer.cpp"); text != texts.end())
            subjects.push_back(
                {"right/" + entry.name, text->second, "", {{"passed"}, {{}}, false}});
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
            build::buildProgram(kit_, sandbox_, sandbox::Limits{}, "Renderer.cpp", subject.source);
        if (!built.program)
            throw raytracer::Error(
                fmt::format("{} does not compile: {}", subject.name, built.diagnostics));
        slot->program = std::make_unique<build::Program>(std::move(*built.program));
    });
    return *slot->program;
}

}  // namespace ticker::calibrate
