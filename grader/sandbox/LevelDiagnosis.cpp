#include <grader/sandbox/HelperProgram.h>
#include <grader/sandbox/LevelDiagnosis.h>
#include <grader/sandbox/Obstacle.h>
#include <grader/sandbox/RunAt.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <unistd.h>

namespace ticker::sandbox {
namespace {

// The first line of bubblewrap's or the helper's message, to quote in a sentence of our own.
std::string firstLine(const std::string& text) {
    std::string line = text.substr(0, text.find('\n'));
    while (!line.empty() && (line.back() == '.' || line.back() == ' '))
        line.pop_back();
    return line.empty() ? "the trial run gave no answer" : line;
}

std::string promise(Level level) {
    switch (level) {
        case Level::namespaces:
            return "bubblewrap with all namespaces, seccomp and limits work";
        case Level::ownUser:
            return "own uid for each job, Landlock, seccomp and limits work";
        case Level::sameUser:
            return "Landlock, seccomp and limits work; jobs share your uid";
        case Level::none:
            break;
    }
    return "limits on time, memory and output only: never for strangers' code";
}

std::string adviceFor(Level level) {
    switch (level) {
        case Level::namespaces:
            return adviceForNamespaces(namespaceSettings());
        case Level::ownUser:
            return "needs a kernel with Landlock (5.13) and a container that permits its system "
                   "calls and setuid";
        case Level::sameUser:
            return "needs a kernel with Landlock (5.13) and seccomp";
        case Level::none:
            break;
    }
    return {};
}

Diagnosis unavailable(Level level, std::string reason, std::string advice) {
    return {level, false, std::move(reason), std::move(advice)};
}

Diagnosis examine(Level level) {
    if (level == Level::namespaces && findBubblewrap().empty())
        return unavailable(level, "bubblewrap is not installed", "apt-get install bubblewrap");
    if (level == Level::ownUser && geteuid() != 0)
        return unavailable(level, "only root can give each job a uid of its own", "");
    if (level == Level::sameUser && geteuid() == 0)
        return unavailable(level, "as root, jobs would share root's uid",
                           "use B, or run as an ordinary user");
    const Outcome outcome = runNothing(level);
    if (outcome.succeeded()) return {level, true, promise(level), ""};
    return unavailable(level, firstLine(outcome.output), adviceFor(level));
}

// An error is a valid result, too, and is kept: the machine will not offer later what it lacks now.
Diagnosis examineSafely(Level level) {
    try {
        return examine(level);
    } catch (const raytracer::Error& error) {
        return unavailable(level, error.what(), "");
    }
}

}  // namespace

const Diagnosis& diagnose(Level level) {
    switch (level) {
        case Level::namespaces: {
            static const Diagnosis known = examineSafely(Level::namespaces);
            return known;
        }
        case Level::ownUser: {
            static const Diagnosis known = examineSafely(Level::ownUser);
            return known;
        }
        case Level::sameUser: {
            static const Diagnosis known = examineSafely(Level::sameUser);
            return known;
        }
        case Level::none:
            break;
    }
    static const Diagnosis known = examineSafely(Level::none);
    return known;
}

std::vector<Diagnosis> diagnose() {
    std::vector<Diagnosis> all;
    for (const Level level : {Level::namespaces, Level::ownUser, Level::sameUser, Level::none})
        all.push_back(diagnose(level));
    return all;
}

std::string refusalOf(const std::vector<Diagnosis>& levels) {
    std::string message = "this machine gives no sandbox; ";
    for (const Diagnosis& level : levels)
        if (!level.available)
            message += fmt::format("{}: {}; ", toString(level.level), level.reason);
    return message + "`ticker doctor` says what each level needs";
}

}  // namespace ticker::sandbox
