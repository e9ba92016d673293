#include <grader/base/MakeFolder.h>
#include <grader/build/Kit.h>
#include <grader/cli/Home.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/package/Platforms.h>
#include <grader/package/StudentPackage.h>
#include <grader/sandbox/HelperProgram.h>

#include <raytracer/base/Error.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

struct PackageOptions {
    std::string kind;
    std::string file;
    std::string rubric;
    std::string studentView;
    std::string exercise;
};

/// All parts that run, found from this ticker's place.
package::Parts partsOf(const PackageOptions& options) {
    const Home home = Home::find();
    const Exercise& exercise = exerciseNamed(options.exercise);
    const build::Kit kit = build::Kit::besideProgram(exercise);
    return {
        .exercise = exercise,
        .program = home.programs / "ticker",
        .helper = sandbox::findProgram("ticker-jail"),
        .decoder = sandbox::findProgram("ticker-decode"),
        .kit = kit.folder(),
        .compiler = kit.compiler(),
        .compileFlags = kit.compileFlags(),
        .linkFlags = kit.linkFlags(),
        .data = home.data,
        .rubric = options.rubric.empty() ? home.data / exercise.rubric : fs::path{options.rubric},
        .studentView =
            options.studentView.empty() ? home.studentView() : fs::path{options.studentView}};
}

void packGradescope(const PackageOptions& options) {
    package::writeGradescope(partsOf(options), options.file);
}

void packPrairieLearn(const PackageOptions& options) {
    package::writePrairieLearn(partsOf(options), options.file);
}

void packStudent(const PackageOptions& options) {
    package::writeStudentPackage(Home::find().data, exerciseNamed(options.exercise), options.file);
}

/// One kind of package. A new kind is one row of this type.
struct Kind {
    const char* name;
    const char* whatItIs;
    void (*write)(const PackageOptions& options);
};

constexpr std::array kKinds{
    Kind{"student", "a zip for students: template, public tests, scenes, handout", packStudent},
    Kind{"gradescope", "a zip for Gradescope's autograder page", packGradescope},
    Kind{"prairielearn", "a zip with an image's Dockerfile and a sample question",
         packPrairieLearn},
};

raytracer::ExitCode pack(const PackageOptions& options, const GlobalOptions& global) {
    const auto* const kind = std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& known) {
        return known.name == options.kind;
    });
    const fs::path folder = fs::path{options.file}.parent_path();
    if (!folder.empty()) makeFolder(folder);
    kind->write(options);
    std::error_code error;
    const std::uintmax_t size = fs::file_size(options.file, error);
    if (!global.quiet)
        fmt::print(stderr, "{}: {}{}\n", options.file, kind->whatItIs,
                   error ? "" : fmt::format(", {:.1f} MB", static_cast<double>(size) / 1e6));
    return raytracer::ExitCode::success;
}

}  // namespace

Run addPackage(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<PackageOptions>();
    std::vector<std::string> names;
    std::string help = "What to make:";
    for (const Kind& kind : kKinds) {
        names.emplace_back(kind.name);
        help += fmt::format(" {} ({})", kind.name, kind.whatItIs);
    }
    CLI::App* verb = app.add_subcommand("package", "Make what is uploaded or handed out");
    verb->add_option("kind", options->kind, help)->required()->check(CLI::IsMember(names));
    verb->add_option("-o,--output", options->file, "The file to write")->required();
    addExerciseOption(*verb, options->exercise);
    verb->add_option("--rubric", options->rubric, "Carry another rubric than the kit's own");
    verb->add_option("--student-view", options->studentView,
                     "Carry another policy of what students may see than the kit's own");
    return [options, &global] { return pack(*options, global); };
}

}  // namespace ticker::cli
