#include <grader/base/WholeFile.h>
#include <grader/cli/Home.h>
#include <grader/cli/Progress.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/lab/LabVerbs.h>
#include <grader/lab/calibrate/Campaigns.h>
#include <grader/lab/calibrate/Document.h>
#include <grader/lab/calibrate/RunCampaign.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;
using calibrate::Campaign;
using calibrate::Record;
using calibrate::Summary;
using Campaigns = std::vector<std::unique_ptr<Campaign>>;

struct CalibrateOptions {
    bool check = false;
    bool report = false;
    std::string only;
    std::string record = "build/calibration";
    int jobs = 2;
    std::string sandbox = "auto";
};

struct Places {
    fs::path document;
    fs::path record;  // folder of the committed records
};

Places placesOf(const Home& home) {
    return {home.data / "docs/calibration.md", home.data / "grader/lab/calibrate/record"};
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream stream{file, std::ios::binary};
    stream << text << std::flush;
    if (!stream) throw raytracer::InputError(file.string(), 0, "cannot be written");
}

// Prints the tables, and updates the document and the committed record.
bool publish(const Campaign& campaign, const Record& record, const Places& places) {
    const Summary summary = campaign.summarise(record.all());
    const std::string text = record.size() == campaign.units()
                                 ? summary.text
                                 : fmt::format("{} of {} units were run.\n\n{}", record.size(),
                                               campaign.units(), summary.text);
    fmt::print("{}{}\n{}\n", campaign.name(), summary.asExpected ? "" : ": NOT AS EXPECTED", text);
    std::fflush(stdout);
    record.copyTo(places.record);
    write(places.document,
          calibrate::withSection(readIfThere(places.document).value_or(""), campaign.name(), text));
    return summary.asExpected;
}

void runWithProgress(Campaign& campaign, Record& record, int jobs, bool draw) {
    Countdown countdown{campaign.name(), record.size(), draw};
    calibrate::runCampaign(campaign, record, jobs,
                           [&](std::size_t done, std::size_t of) { countdown.show(done, of); });
}

// Checks that the committed tables follow from the committed records, and that some units repeat as
// recorded.
bool check(Campaign& campaign, const Places& places, int jobs) {
    const Record record{places.record, campaign};
    std::vector<std::string> wrong = calibrate::checkCampaign(campaign, record, jobs);
    const Summary summary = campaign.summarise(record.all());
    if (calibrate::sectionOf(readIfThere(places.document).value_or(""), campaign.name())
            .find(summary.text) == std::string::npos)
        wrong.push_back(campaign.name() +
                        ": docs/calibration.md does not have the record's tables");
    if (!summary.asExpected) wrong.push_back(campaign.name() + ": the record is not as expected");
    for (const std::string& line : wrong)
        fmt::print("{}\n", line);
    if (wrong.empty())
        fmt::print("{}: {} units again, each as recorded\n", campaign.name(),
                   campaign.checkUnits().size());
    std::fflush(stdout);
    return wrong.empty();
}

bool calibrateOne(Campaign& campaign, const CalibrateOptions& options, const Places& places,
                  bool draw) {
    if (options.check) return check(campaign, places, options.jobs);
    Record record{options.record, campaign};
    if (!options.report) runWithProgress(campaign, record, options.jobs, draw);
    return publish(campaign, record, places);
}

/// An installation has neither the record nor the solutions of a campaign.
void requireCheckout(const Home& home) {
    for (const char* folder : {"grader/lab/calibrate/record", "grader/corpus/unseen"})
        if (!fs::is_directory(home.data / folder))
            throw raytracer::InputError(
                (home.data / folder).string(), 0,
                "is not there: calibrate works in the project's checkout only; run ./tick "
                "calibrate there");
}

raytracer::ExitCode calibrateAll(const CalibrateOptions& options, const GlobalOptions& global) {
    const Home home = Home::find();
    requireCheckout(home);
    const build::Kit kit = build::Kit::besideProgram();
    const sandbox::Sandbox sandbox = openSandbox(options.sandbox);
    calibrate::Programs programs{kit, sandbox};
    bool good = true;
    bool any = false;
    for (const auto& campaign : calibrate::campaigns(home.data, programs)) {
        if (!options.only.empty() && campaign->name() != options.only) continue;
        any = true;
        good = calibrateOne(*campaign, options, placesOf(home), mayDraw(global.quiet)) && good;
    }
    if (!any) throw raytracer::InputError("--only", 0, "there is no campaign " + options.only);
    return good ? raytracer::ExitCode::success : raytracer::ExitCode::checkFailed;
}

}  // namespace

Run addCalibrate(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<CalibrateOptions>();
    CLI::App* verb = app.add_subcommand(
        "calibrate",
        "Measures how often verdicts are wrong; writes docs/calibration.md of a checkout");
    CLI::Option* check = verb->add_flag(
        "--check", options->check, "Repeat a small part and compare it with the committed record");
    verb->add_flag("--report", options->report, "Run nothing: write what the record has so far")
        ->excludes(check);
    verb->add_option("--only", options->only, "One campaign: correct, stages, mistakes, ...");
    verb->add_option("--record", options->record,
                     "Folder that keeps every finished unit, to go on after a stop");
    verb->add_option("--jobs", options->jobs, "Threads")->check(CLI::Range(1, 256));
    verb->add_option("--sandbox", options->sandbox, "Level A, B or C; auto: the best")
        ->check(CLI::IsMember({"auto", "A", "B", "C"}));
    return [options, &global] { return calibrateAll(*options, global); };
}

}  // namespace ticker::cli
