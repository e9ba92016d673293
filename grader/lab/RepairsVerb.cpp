#include <grader/base/WholeFile.h>
#include <grader/build/Kit.h>
#include <grader/cli/Home.h>
#include <grader/cli/ProgressLine.h>
#include <grader/cli/verbs/GradeOptions.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/corpus/Entry.h>
#include <grader/lab/LabVerbs.h>
#include <grader/lab/repairs/RepairCampaign.h>
#include <grader/lab/repairs/RepairRecord.h>
#include <grader/lab/repairs/SeveralMistakes.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace ticker::cli {
namespace {

struct RepairsOptions {
    lab::RepairChoice choice;
    bool report = false;
    std::string record = "build/repairs.jsonl";
    std::string write;
    GradeOptions grade;
};

/// The rows of all units. A unit that is not in the record is run, and its row added and printed;
/// for a report it is left out.
std::vector<lab::RepairRow> rowsOf(const lab::RepairCampaign& campaign, lab::RepairRecord& record,
                                   bool isReport, bool draw) {
    std::size_t missing = 0;
    for (std::size_t unit = 0; unit < campaign.size(); ++unit)
        if (record.find(campaign.nameOf(unit)) == nullptr) ++missing;
    const Countdown countdown{"repairs", 0, draw};
    std::vector<lab::RepairRow> rows;
    std::size_t run = 0;
    for (std::size_t unit = 0; unit < campaign.size(); ++unit) {
        if (const lab::RepairRow* known = record.find(campaign.nameOf(unit))) {
            rows.push_back(*known);
            continue;
        }
        if (isReport) continue;
        rows.push_back(campaign.run(unit));
        record.add(rows.back());
        // The row takes the place of the line that was drawn.
        if (draw) std::fputs(drawnLine("", 0).c_str(), stderr);
        fmt::print("{}/{}: {}\n", ++run, missing, lab::lineOf(rows.back()));
        std::fflush(stdout);
        countdown.show(run, missing);
    }
    return rows;
}

/// Input of the tables, from one exercise or several.
struct Repairs {
    std::size_t entries = 0;  ///< number that fits the options, with or without a row
    std::vector<lab::RepairRow> rows;
};

Repairs repairsOf(const Exercise& exercise, const RepairsOptions& options, bool draw) {
    GradeOptions grade = options.grade;
    grade.exercise = exercise.name;
    const pipeline::Grader grader = makeGrader(grade);
    const auto entries =
        corpus::readEntries(Home::find().data, options.choice.collections, exercise);
    const lab::RepairCampaign campaign{grader, entries, options.choice, seedOf(options.grade)};
    lab::RepairRecord record{options.record};
    return {campaign.size(), rowsOf(campaign, record, options.report, draw)};
}

raytracer::ExitCode repairs(const RepairsOptions& options, const GlobalOptions& global) {
    if (!options.grade.exercise.empty()) static_cast<void>(exerciseNamed(options.grade.exercise));
    const lab::SeveralMistakes several = lab::readSeveralMistakes(Home::find().data);
    Repairs all;
    for (const Exercise& exercise : knownExercises()) {
        if (!options.grade.exercise.empty() && options.grade.exercise != exercise.name) continue;
        const Repairs some = repairsOf(exercise, options, mayDraw(global.quiet));
        all.entries += some.entries;
        all.rows.insert(all.rows.end(), some.rows.begin(), some.rows.end());
    }
    if (all.entries == 0)
        throw raytracer::InputError("", 0,
                                    "no entry fits --task, --case, --collection and the other "
                                    "options; nothing is written");
    const std::string tables = lab::tablesOf(all.rows, several);
    fmt::print("\n{}", tables);
    if (options.write.empty()) return raytracer::ExitCode::success;
    const std::string before = readIfThere(options.write).value_or("");
    writeAtomically(lab::withTables(before, tables), options.write);
    return raytracer::ExitCode::success;
}

}  // namespace

Run addRepairsLab(CLI::App& app, const GlobalOptions& global) {
    auto options = std::make_shared<RepairsOptions>();
    constexpr std::uint64_t kUsualSeed = 1;
    options->grade.seed = kUsualSeed;
    CLI::App* verb = app.add_subcommand(
        "repairs", "How many mistakes of the corpus are explained by a proven edit, and where");
    verb->add_option("--task", options->choice.task, "Only mistakes of this task");
    verb->add_option("--case", options->choice.cases, "Only entries of these names")
        ->delimiter(',');
    verb->add_option("--collection", options->choice.collections,
                     "Only these of mistakes (the catalogue), unseen and samples")
        ->delimiter(',')
        ->check(CLI::IsMember({"mistakes", "unseen", "samples"}));
    verb->add_flag("--one-edit", options->choice.ofOneEdit,
                   "Of the catalogue's mistakes only those of one edit");
    verb->add_option("--fraction", options->choice.fraction, "Share of the entries to run")
        ->check(CLI::Range(0.0, 1.0));
    verb->add_option("--record", options->record,
                     "File that keeps every finished row, to go on after a stop; delete it after a "
                     "change of code or of --seed");
    verb->add_flag("--report", options->report, "Run nothing: the tables of the record so far");
    verb->add_option("--write", options->write,
                     "Writes the tables into a document, between its marks");
    verb->add_option("--exercise", options->grade.exercise, "Only this exercise; otherwise all");
    verb->add_option("--sandbox", options->grade.sandbox, "Level A, B or C; auto: the best")
        ->check(CLI::IsMember({"auto", "A", "B", "C"}));
    verb->add_option("--seed", options->grade.seed,
                     "Whole number that the hidden questions are drawn from; 1 unless told");
    return [options, &global] { return repairs(*options, global); };
}

}  // namespace ticker::cli
