#include <grader/base/WholeFile.h>
#include <grader/build/Kit.h>
#include <grader/cli/Home.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/report/Escape.h>
#include <grader/report/ReportWords.h>
#include <grader/sandbox/Sandbox.h>
#include <grader/similar/SimilarPage.h>
#include <grader/store/ClassFolder.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

struct SimilarOptions {
    std::string out;
    int leastPercent = similar::kLeastPercent;
};

// A longer file is no work on this exercise, and takes the matcher minutes.
constexpr std::size_t kLargestFile = 200'000;

/// The files of a class, and the names of those that are too long.
void addFiles(const fs::path& out, const std::vector<store::ClassEntry>& entries,
              similar::ComparedFile& file) {
    for (const store::ClassEntry& entry : entries) {
        const std::string& name = entry.result.submission;
        const fs::path path = out / name / "code" / file.name;
        std::error_code error;
        if (!fs::is_regular_file(fs::symlink_status(path, error))) continue;
        std::string text = readIfThere(path).value_or("");
        if (text.size() <= kLargestFile)
            file.files.push_back({name, std::move(text)});
        else
            file.leftOut.push_back(name);
    }
}

similar::ComparedFile compared(const fs::path& out, const std::string& file,
                               const std::vector<store::ClassEntry>& entries,
                               const Exercise& exercise, int leastPercent) {
    const std::vector<std::string> known{build::Kit::besideProgram(exercise).templateSource(file),
                                         readWhole(Home::find().data / exercise.reference / file)};
    similar::ComparedFile result{file, {}, {}};
    addFiles(out, entries, result);
    result.comparison =
        similar::compareFiles(result.files, known, sandbox::Sandbox::best(), leastPercent);
    return result;
}

void printPairs(const similar::ComparedFile& file) {
    for (const similar::SimilarPair& pair : file.comparison.pairs)
        fmt::print("{:>3} %  {}  {} and {}\n", pair.percent, file.name,
                   report::escapeLine(file.files[pair.left].submission),
                   report::escapeLine(file.files[pair.right].submission));
}

/// Printed even with --quiet: a copy that was made too long by padding must not go unnoticed.
void nameLeftOut(const similar::ComparedFile& file) {
    for (const std::string& submission : file.leftOut)
        fmt::print(stderr, "left out: {} of {} has more than {} bytes; compare it yourself\n",
                   file.name, report::escapeLine(submission), kLargestFile);
}

raytracer::ExitCode findSimilar(const SimilarOptions& options, const GlobalOptions& global) {
    const fs::path out = options.out;
    const std::vector<store::ClassEntry> entries = store::readClass(out);
    const Exercise& exercise =
        entries.empty() ? defaultExercise() : exerciseOf(entries.front().result);
    std::vector<similar::ComparedFile> all;
    for (const std::string& file : exercise.files())
        all.push_back(compared(out, file, entries, exercise, options.leastPercent));
    for (const similar::ComparedFile& file : all)
        printPairs(file);
    for (const similar::ComparedFile& file : all)
        nameLeftOut(file);
    writeAtomically(similar::similarPage(all), out / "similar.html");
    writeAtomically(similar::similarJson(all), out / "similar.json");
    if (!global.quiet) fmt::print(stderr, "open {}\n", (out / "similar.html").string());
    return raytracer::ExitCode::success;
}

}  // namespace

Run addSimilar(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<SimilarOptions>();
    CLI::App* verb = app.add_subcommand(
        "similar", "Pairs of submissions that share more than the template and the exercise");
    verb->add_option("out", options->out, "Folder that ticker grade wrote")->required();
    verb->add_option("--least", options->leastPercent,
                     "Least percentage of shared code of their own")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    return [options, &global] { return findSimilar(*options, global); };
}

}  // namespace ticker::cli
