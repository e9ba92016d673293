#include <grader/sandbox/LevelDiagnosis.h>
#include <grader/sandbox/RunAt.h>
#include <grader/sandbox/Sandbox.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

namespace ticker::sandbox {

std::string toString(Level level) {
    switch (level) {
        case Level::namespaces:
            return "A";
        case Level::ownUser:
            return "B";
        case Level::sameUser:
            return "C";
        case Level::none:
            break;
    }
    return "none";
}

Sandbox Sandbox::best() {
    for (const Level level : {Level::namespaces, Level::ownUser, Level::sameUser})
        if (diagnose(level).available) return Sandbox{level};
    throw raytracer::Error(refusalOf(diagnose()));
}

Sandbox Sandbox::at(Level level) {
    const Diagnosis& diagnosis = diagnose(level);
    if (diagnosis.available) return Sandbox{level};
    throw raytracer::Error(fmt::format("sandbox level {} is not to be had here: {}{}{}",
                                       toString(level), diagnosis.reason,
                                       diagnosis.advice.empty() ? "" : "; ", diagnosis.advice));
}

std::filesystem::path Sandbox::makeStagingFolder() {
    return staging().makeFolder(std::filesystem::perms{0711});
}

std::filesystem::path Sandbox::pathFor(const ReadOnlyPath& path) const {
    return level_ == Level::namespaces ? path.inside : path.host;
}

Outcome Sandbox::run(const Command& command) const {
    return runAt(level_, command);
}

}  // namespace ticker::sandbox
