#include <grader/cli/ClassRun.h>
#include <grader/cli/Output.h>
#include <grader/cli/verbs/StudentPages.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/report/ReportWords.h>
#include <grader/store/ClassFolder.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace ticker::cli {
namespace {

struct CollectOptions {
    std::string out;
    std::string studentView;
};

raytracer::ExitCode collect(const CollectOptions& options, const GlobalOptions& global) {
    const std::string& out = options.out;
    std::error_code error;
    if (!std::filesystem::is_directory(out, error))
        throw raytracer::InputError(out, 0,
                                    (error ? error.message() : std::string{"is no folder"}) +
                                        "; expected a folder with results below");
    store::Store store{out};
    if (!store.notice().empty()) fmt::print(stderr, "ticker: {}\n", store.notice());
    const store::Collected collected = store::collect(out, store);
    for (const std::string& problem : collected.unreadable)
        fmt::print(stderr, "ticker: {}\n", problem);
    const std::vector<store::ClassEntry> entries =
        store::readClass(out, store::Unreadable::leaveOut);
    if (entries.empty())
        throw raytracer::InputError(
            out, 0, "holds no result that can be read; expected folders with a result.json");
    if (!rememberOrigin(store, resultsOf(entries)))
        fmt::print(stderr,
                   "ticker: the results of {} have more than one seed; grade --resume keeps those "
                   "with its own alone, which --seed sets\n",
                   out);
    writeClass(out, entries);
    writeStudentPages(out, entries, options.studentView);
    if (!global.quiet)
        fmt::print(stderr, "{} taken in, {} known already\nopen {}/index.html\n",
                   report::counted(collected.taken, "result"), collected.known, out);
    return collected.unreadable.empty() ? raytracer::ExitCode::success
                                        : raytracer::ExitCode::notGradable;
}

}  // namespace

Run addCollect(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<CollectOptions>();
    CLI::App* verb = app.add_subcommand(
        "collect", "Take in results that were written into OUT elsewhere, by a cluster's nodes");
    verb->add_option("out", options->out, "Folder with <submission>/result.json files")->required();
    addStudentView(*verb, options->studentView);
    return [options, &global] { return collect(*options, global); };
}

}  // namespace ticker::cli
