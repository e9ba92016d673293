#include <grader/cli/Output.h>
#include <grader/cli/Verb.h>
#include <grader/report/ResultJson.h>
#include <grader/report/SummaryCsv.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

/// A format of the whole class: all results in, text on stdout.
using Renderer = std::function<std::string(const std::vector<SubmissionResult>&)>;

const std::map<std::string, Renderer>& formats() {
    static const std::map<std::string, Renderer> kFormats{
        {"csv", report::summaryCsv},
        {"json",
         [](const std::vector<SubmissionResult>& results) {
             std::string text = "[\n";
             for (std::size_t i = 0; i < results.size(); ++i)
                 text += report::resultJson(results[i]) + (i + 1 < results.size() ? "," : "");
             return text + "]\n";
         }},
    };
    return kFormats;
}

/// The format that is written into OUT instead of printed: the pages.
constexpr std::string_view kPages = "html";

struct ReportOptions {
    std::string folder;
    std::string format = "csv";
    std::string submission;
};

raytracer::ExitCode rewrite(const ReportOptions& options, const Voice& voice) {
    rewritePages(options.folder, options.submission);
    if (!voice.quiet) fmt::print(stderr, "open {}/index.html\n", options.folder);
    return raytracer::ExitCode::success;
}

raytracer::ExitCode print(const ReportOptions& options) {
    std::vector<SubmissionResult> results = readResults(options.folder);
    if (!options.submission.empty()) {
        std::erase_if(results, [&](const SubmissionResult& result) {
            return result.submission != options.submission;
        });
        if (results.empty()) throw noSuchSubmission(options.folder, options.submission);
    }
    fmt::print("{}", formats().at(options.format)(results));
    return raytracer::ExitCode::success;
}

std::vector<std::string> formatNames() {
    std::vector<std::string> names{std::string{kPages}};
    for (const auto& [name, unused] : formats())
        names.push_back(name);
    return names;
}

}  // namespace

Run addReport(CLI::App& app, const Voice& voice) {
    auto options = std::make_shared<ReportOptions>();
    CLI::App* verb = app.add_subcommand("report", "Give the results in OUT in another format");
    verb->add_option("out", options->folder, "Folder that ticker grade wrote")->required();
    verb->add_option("--format", options->format,
                     "csv or json, printed; html: writes the pages in OUT anew")
        ->check(CLI::IsMember(formatNames()));
    verb->add_option("--submission", options->submission, "Only this one");
    return [options, &voice] {
        return options->format == kPages ? rewrite(*options, voice) : print(*options);
    };
}

}  // namespace ticker::cli
