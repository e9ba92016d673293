#include <grader/base/WholeFile.h>
#include <grader/cli/Home.h>
#include <grader/cli/ProgressLine.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/lab/LabVerbs.h>
#include <grader/lab/calibrate/Campaigns.h>
#include <grader/lab/calibrate/Document.h>
#include <grader/lab/calibrate/RunCampaign.h>
#include <grader/lab/calibrate/Staleness.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;
using calibrate::Campaign;
using calibrate::Record;
using calibrate::Stamp;
using calibrate::Summary;
using Campaigns = std::vector<std::unique_ptr<Campaign>>;

struct CalibrateOptions {
    bool check = false;
    bool repeats = false;
    bool records = false;
    bool report = false;
    std::string only;
    std::string entry;
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

// Prints the tables, and updates the document and the committed record.
bool publish(const Campaign& campaign, const Record& record, const std::vector<Stamp>& stamps,
             const Places& places) {
    const Summary summary = campaign.summarise(record.all());
    const std::size_t current = calibrate::currentUnits(record, stamps);
    std::string text = summary.text;
    if (current < campaign.units())
        text = fmt::format("{} of {} units were run, {} of them by an earlier version.\n\n",
                           record.size(), campaign.units(), record.size() - current) +
               text;
    fmt::print("{}{}\n{}\n", campaign.name(), summary.asExpected ? "" : ": NOT AS EXPECTED", text);
    std::fflush(stdout);
    record.copyTo(places.record);
    calibrate::writeIfChanged(
        calibrate::withSection(readIfThere(places.document).value_or(""), campaign.name(), text),
        places.document);
    return summary.asExpected;
}

void runWithProgress(Campaign& campaign, Record& record, const std::vector<Stamp>& stamps,
                     const CalibrateOptions& options, bool draw) {
    Countdown countdown{campaign.name(), calibrate::currentUnits(record, stamps), draw};
    calibrate::runCampaign(
        campaign, record, stamps, options.jobs,
        [&](std::size_t done, std::size_t of) { countdown.show(done, of); }, options.entry);
}

bool report(const std::vector<std::string>& wrong) {
    for (const std::string& line : wrong)
        fmt::print("{}\n", line);
    return wrong.empty();
}

// Whether every unit of the committed record was measured with today's code.
bool checkCode(const Campaign& campaign, const Record& record, const calibrate::Parts& parts) {
    const bool good = report(
        calibrate::stalenessOf(campaign, record, calibrate::stampsOf(campaign, parts), parts));
    if (good) fmt::print("{}: {} units, each of today's code\n", campaign.name(), record.size());
    std::fflush(stdout);
    return good;
}

// Whether the committed tables follow from the committed record, and the units that are run again
// give the recorded results.
bool checkRepeats(Campaign& campaign, const Record& record, const Places& places, int jobs) {
    std::vector<std::string> wrong = calibrate::checkCampaign(campaign, record, jobs);
    const Summary summary = campaign.summarise(record.all());
    if (calibrate::sectionOf(readIfThere(places.document).value_or(""), campaign.name())
            .find(summary.text) == std::string::npos)
        wrong.push_back(campaign.name() +
                        ": docs/calibration.md does not have the record's tables");
    if (!summary.asExpected) wrong.push_back(campaign.name() + ": the record is not as expected");
    if (report(wrong))
        fmt::print("{}: {} units again, each as recorded\n", campaign.name(),
                   campaign.checkUnits().size());
    std::fflush(stdout);
    return wrong.empty();
}

bool calibrateOne(Campaign& campaign, const CalibrateOptions& options, const Places& places,
                  const calibrate::Parts& parts, bool draw) {
    const Record committed{places.record, campaign};
    if (options.check) {
        const bool isCurrent = options.repeats || checkCode(campaign, committed, parts);
        return (options.records || checkRepeats(campaign, committed, places, options.jobs)) &&
               isCurrent;
    }
    const std::vector<Stamp> stamps = calibrate::stampsOf(campaign, parts);
    Record record{options.record, campaign};
    record.adopt(committed, stamps);
    if (!options.report) runWithProgress(campaign, record, stamps, options, draw);
    return publish(campaign, record, stamps, places);
}

/// Refuses to run outside a checkout: an installation has neither the record nor the solutions of a
/// campaign.
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
    const calibrate::Parts parts{home.data};
    const sandbox::Sandbox sandbox = openSandbox(options.sandbox);
    calibrate::Programs programs{sandbox};
    bool good = true;
    bool any = false;
    for (const auto& campaign : calibrate::campaigns(home.data, programs)) {
        if (!options.only.empty() && campaign->name() != options.only) continue;
        any = true;
        good =
            calibrateOne(*campaign, options, placesOf(home), parts, mayDraw(global.quiet)) && good;
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
        "--check", options->check,
        "Compare the committed record with today's code, and repeat a small part of it");
    CLI::Option* records = verb->add_flag("--records", options->records,
                                          "With --check: compare the code alone, and run nothing")
                               ->needs(check);
    verb->add_flag("--repeat", options->repeats, "With --check: repeat the small part alone")
        ->needs(check)
        ->excludes(records);
    verb->add_flag("--report", options->report,
                   "Run nothing: write what the record has so far into docs/calibration.md and "
                   "grader/lab/calibrate/record")
        ->excludes(check);
    verb->add_option("--only", options->only, "One campaign: correct, stages, mistakes, ...");
    verb->add_option("--entry", options->entry, "Run only units whose name contains this text")
        ->excludes(check);
    verb->add_option("--record", options->record,
                     "Folder that keeps every finished unit, to go on after a stop");
    verb->add_option("--jobs", options->jobs, "Threads")->check(CLI::Range(1, 256));
    verb->add_option("--sandbox", options->sandbox, "Level A, B or C; auto: the best")
        ->check(CLI::IsMember({"auto", "A", "B", "C"}));
    return [options, &global] { return calibrateAll(*options, global); };
}

}  // namespace ticker::cli
