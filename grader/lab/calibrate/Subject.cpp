#include <grader/base/WholeFile.h>
#include <grader/build/Build.h>
#include <grader/lab/calibrate/Subject.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace ticker::calibrate {
namespace {

namespace fs = std::filesystem;

}  // namespace

bool Subject::isUnseen() const {
    return expect.finding == "shadow.unseen-rays" || expect.finding == "dof.unseen-rays" ||
           name.find("/unseen-") != std::string::npos ||
           name.find("/own-code-") != std::string::npos;
}

bool Subject::isStatistical() const {
    constexpr std::array kOfDistributions{"shadow.light-size", "shadow.not-a-ball",
                                          "dof.aperture-size", "dof.disc", "dof.off-centre"};
    return isUnseen() || std::find(kOfDistributions.begin(), kOfDistributions.end(),
                                   expect.finding) != kOfDistributions.end();
}

std::vector<Subject> readSubjects(const fs::path& data) {
    const std::string reference = readWhole(data / "reference_solution/exercise/Renderer.cpp");
    std::vector<Subject> subjects;
    for (const mistakes::Mistake& mistake : mistakes::readCatalogue(data / "grader/corpus"))
        if (mistake.task.rfind("T2.", 0) == 0)
            subjects.push_back({mistake.task + "/" + mistake.id,
                                mistakes::makeMistake(mistake, reference), mistake.task,
                                mistake.expect});
    for (const char* folder : {"grader/corpus/unseen/T2/right", "grader/corpus/samples/awarded"})
        for (const auto& entry : fs::directory_iterator{data / folder})
            if (fs::exists(entry.path() / "Renderer.cpp"))
                subjects.push_back({"right/" + entry.path().filename().string(),
                                    readWhole(entry.path() / "Renderer.cpp"),
                                    "",
                                    {TaskState::passed, ""}});
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
        build::BuildResult built = build::buildProgram(kit_, sandbox_, sandbox::Limits{},
                                                       build::SourceFile::renderer, subject.source);
        if (!built.program)
            throw raytracer::Error(
                fmt::format("{} does not compile: {}", subject.name, built.diagnostics));
        slot->program = std::make_unique<build::Program>(std::move(*built.program));
    });
    return *slot->program;
}

}  // namespace ticker::calibrate
