#include <grader/cli/Formats.h>
#include <grader/cli/Output.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/store/ClassFolder.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace ticker::cli {
namespace {

struct ReportOptions {
    std::string folder;
    std::string format = "csv";
    std::string submission;
    FormatOptions formats;
};

std::vector<store::ClassEntry> chosen(const ReportOptions& options) {
    std::vector<store::ClassEntry> entries = store::readClass(options.folder);
    if (options.submission.empty()) return entries;
    std::erase_if(entries, [&](const store::ClassEntry& entry) {
        return entry.result.submission != options.submission;
    });
    if (entries.empty())
        throw raytracer::InputError(
            options.folder, 0,
            fmt::format("no result of a submission named \"{}\"", options.submission));
    return entries;
}

raytracer::ExitCode report(ReportOptions options) {
    const std::vector<store::ClassEntry> entries = chosen(options);
    if (options.format == "csv" || options.format == "json") {
        fmt::print("{}", options.format == "csv" ? summaryOf(entries)
                                                 : allResultsJson(resultsOf(entries)));
        return raytracer::ExitCode::success;
    }
    options.formats.names = {options.format};
    for (const std::filesystem::path& file : writeFormats(options.folder, entries, options.formats))
        fmt::print("{}\n", file.string());
    return raytracer::ExitCode::success;
}

}  // namespace

Run addReport(CLI::App& app, const GlobalOptions& /*global*/) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App* verb = app.add_subcommand("report", "The results in OUT in another format");
    verb->add_option("out", options->folder, "Folder that ticker grade wrote")->required();
    verb->add_option("--format", options->format,
                     "csv and json go to stdout; the others become files in OUT, whose names are "
                     "printed")
        ->check(CLI::IsMember(formatNames()));
    verb->add_option("--submission", options->submission, "Only this one");
    addFormatOptions(*verb, options->formats);
    return [options] { return report(*options); };
}

}  // namespace ticker::cli
