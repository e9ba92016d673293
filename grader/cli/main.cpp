#include <grader/cli/VerbProgram.h>

#include <CLI/CLI.hpp>

namespace ticker::cli {
namespace {

/// A verb that only ticker-lab has: fails with the command that runs it there.
template <const char* const& name>
Run addElsewhere(CLI::App& app, const GlobalOptions& /*global*/) {
    app.add_subcommand(name)->group("")->allow_extras()->fallthrough(false)->set_help_flag();
    return []() -> raytracer::ExitCode {
        throw raytracer::InputError(name, 0, std::string{"is in ticker-lab: ./tick "} + name);
    };
}

constexpr const char* kSelftest = "selftest";
constexpr const char* kCalibrate = "calibrate";
constexpr const char* kRepairs = "repairs";
constexpr const char* kSimilarity = "similarity";
constexpr const char* kCoverage = "coverage";

}  // namespace
}  // namespace ticker::cli

// CLI11 throws here only if options are declared wrongly.
int main(int argc, char** argv) {
    using namespace ticker::cli;
    return runProgram(
        {"ticker",
         "Grades ray-tracing exercises: tick 1 (intersections, shading, shadows, reflections) and "
         "tick 1* (bump mapping, soft shadows, depth of field)."},
        {addGrade, addCheck, addExplain, addRender, addReport, addDoctor, addCompare, addRefs,
         addPackage, addCollect, addSession, addAppeal, addSimilar, addElsewhere<kSelftest>,
         addElsewhere<kCalibrate>, addElsewhere<kRepairs>, addElsewhere<kSimilarity>,
         addElsewhere<kCoverage>},
        argc, argv);
}
