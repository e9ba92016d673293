#include <grader/repair/TaskExplanation.h>

#include <grader/repair/LineEdits.h>
#include <grader/repair/Proof.h>
#include <grader/repair/TaskLookup.h>
#include <grader/result/GeneralFindings.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

namespace ticker::repair {
namespace {

// The first repair, and one more that students and tickers may compare it with.
constexpr std::size_t kMostRepairs = 2;
// Sets of one kind of edits that pass the search and are put to the proof.
constexpr std::size_t kMostProofs = 4;
// First edits of two mistakes that are followed up.
constexpr std::size_t kMostPartials = 12;
// The share of the time for two mistakes in which first edits are looked for.
constexpr double kShareOfFirst = 0.5;

}  // namespace

TaskExplanation::TaskExplanation(Workbench& workbench, const TaskReport& task,
                                 const Setting& setting, double endMs)
    : workbench_(workbench),
      task_(task),
      setting_(setting),
      finding_(firstFailure(task)),
      beginMs_(setting.clock.cpuMs()),
      endMs_(endMs) {}

TaskRepairs TaskExplanation::run() {
    struct Kind {
        double untilShare;  // of the task's time: then the next kind has its turn
        std::function<Repairs()> repairs;
    };
    const SearchLimits& limits = setting_.limits;
    const Kind kinds[] = {{1.0, [this] { return noLongerStatic(); }},
                          {limits.singles, [this] { return anyOf(Reach::simple, singles); }},
                          {limits.formulas, [this] { return formulas(); }},
                          {limits.wide, [this] { return anyOf(Reach::wide, singles); }},
                          {limits.twins, [this] { return doubleForInt(); }},
                          {limits.twins, [this] { return anyOf(Reach::simple, twins); }},
                          {limits.twins, [this] { return anyOf(Reach::wide, twins); }},
                          {limits.pairs, [this] { return anyOf(Reach::simple, linked); }},
                          {limits.pairs, [this] { return anyOf(Reach::simple, pairs); }},
                          {limits.twoMistakes, [this] { return twoMistakes(); }},
                          {1.0, [this] { return compiledApart(); }}};
    TaskRepairs found;
    for (const Kind& kind : kinds) {
        setting_.clock.endStepAt(timeAt(kind.untilShare));
        found.repairs = kind.repairs();
        if (!found.repairs.empty()) break;
        found.wasCutOff = found.wasCutOff || setting_.clock.isStepOver();
    }
    for (const auto& [reach, search] : searches_)
        found.asked += search.asked();
    return found;
}

TaskExplanation::Repairs TaskExplanation::noLongerStatic() {
    Bench* bench = workbench_.bench(Reach::simple);
    if (bench == nullptr) return {};
    for (const EditSet& set : withoutSwitch(bench->candidates, [this](const Atom& atom) {
             return atom.kind == "static" && !isOfAnotherTask(atom.function);
         }))
        if (Repairs repairs = proven(*bench, {set}); !repairs.empty()) return repairs;
    return {};
}

TaskExplanation::Repairs TaskExplanation::formulas() {
    constexpr std::size_t kMostTried = 6;  // each is compiled and judged
    Bench* bench = workbench_.bench(Reach::wide);
    if (bench == nullptr) return {};
    const Choice isFormula = [this](const Atom& atom) {
        return atom.kind == kFormulaKind && !isOfAnotherTask(atom.function);
    };
    Repairs repairs = proven(searchOf(Reach::wide, *bench), *bench,
                             singles(workbench_.source(), bench->candidates, isFormula));
    if (!repairs.empty()) return repairs;
    auto sets = withoutSwitch(bench->candidates, isFormula);
    sets.resize(std::min(sets.size(), kMostTried));
    return proven(*bench, sets);
}

TaskExplanation::Repairs TaskExplanation::doubleForInt() {
    constexpr std::size_t kMostTried = 2;
    Bench* bench = workbench_.bench(Reach::simple);
    if (bench == nullptr) return {};
    auto sets = withoutSwitch(bench->candidates, [this](const Atom& atom) {
        return atom.kind == "type" && !isOfAnotherTask(atom.function);
    });
    sets.resize(std::min(sets.size(), kMostTried));
    return proven(*bench, sets);
}

TaskExplanation::Repairs TaskExplanation::compiledApart() {
    Bench* bench = workbench_.bench(Reach::simple);
    if (bench == nullptr) return {};
    return proven(*bench, withoutSwitch(bench->candidates, [this](const Atom& atom) {
        return atom.kind != "static" && atom.kind != "type" && !isOfAnotherTask(atom.function);
    }));
}

TaskExplanation::Repairs TaskExplanation::anyOf(Reach reach, MakeSets make) {
    Bench* bench = workbench_.bench(reach);
    if (bench == nullptr) return {};
    std::vector<EditSet> sets = make(workbench_.source(), bench->candidates, choice());
    // Code that crashes mostly lacks a bound.
    if (isRunEnd(finding_))
        std::stable_partition(sets.begin(), sets.end(), [&](const EditSet& set) {
            return bench->candidates.atoms[set.front()].kind == "bound";
        });
    return proven(searchOf(reach, *bench), *bench, sets);
}

TaskExplanation::Repairs TaskExplanation::twoMistakes() {
    Bench* bench = workbench_.bench(Reach::simple);
    if (bench == nullptr) return {};
    Search& search = searchOf(Reach::simple, *bench);
    std::vector<EditSet> ones = lightSingles(workbench_.source(), bench->candidates, choice());
    std::erase_if(ones, [&](const EditSet& set) { return search.isIdle(set); });

    Clock& clock = setting_.clock;
    const double beginMs = clock.cpuMs();
    const double stepEndMs = clock.stepEndMs();
    clock.endStepAt(beginMs + kShareOfFirst * (stepEndMs - beginMs));
    const std::vector<Partial> partials = search.changing(ones, finding_);
    clock.endStepAt(stepEndMs);
    for (std::size_t i = 0; i < std::min(kMostPartials, partials.size()); ++i) {
        const auto both = together(bench->candidates, partials[i].set, ones);
        Repairs repairs = proven(search, *bench, both);
        if (!repairs.empty()) return repairs;
    }
    for (const Partial& partial : partials)
        if (mendsSome(partial))
            if (auto repair = provenOne(*bench, partial.set, partial.next))
                return {*std::move(repair)};
    return {};
}

bool TaskExplanation::mendsSome(const Partial& partial) const {
    const std::vector<std::string> before = failuresOf(task_);
    return partial.failures.size() < before.size() &&
           std::ranges::includes(before, partial.failures);
}

TaskExplanation::Repairs TaskExplanation::proven(const Bench& bench,
                                                 const std::vector<EditSet>& sets) {
    Repairs repairs;
    std::set<std::string> known;
    setting_.clock.endStepAt(endMs_);
    for (const EditSet& set : sets) {
        const auto edited = withEdits(workbench_.source(), textEdits(bench.candidates, set));
        if (repairs.size() == kMostRepairs || setting_.clock.isStepOver()) break;
        if (!edited || !known.insert(*edited).second) continue;
        if (auto repair = provenOne(bench, set, "")) repairs.push_back(*std::move(repair));
    }
    return repairs;
}

TaskExplanation::Repairs TaskExplanation::proven(Search& search, const Bench& bench,
                                                 const std::vector<EditSet>& sets) {
    Repairs repairs;
    std::set<std::string> known;
    search.eachPassing(sets, [&](const EditSet& set) {
        const auto edited = withEdits(workbench_.source(), textEdits(bench.candidates, set));
        if (!edited || !known.insert(*edited).second) return true;
        if (auto repair = provenOne(bench, set, "")) repairs.push_back(*std::move(repair));
        // A second repair is worth less time than the first.
        if (!repairs.empty()) setting_.clock.endStepAt(timeAt(setting_.limits.others));
        return repairs.size() < kMostRepairs && known.size() < kMostProofs;
    });
    return repairs;
}

std::optional<Repair> TaskExplanation::provenOne(const Bench& bench, const EditSet& set,
                                                 const std::string& next) {
    const auto edits = textEdits(bench.candidates, set);
    const auto edited = withEdits(workbench_.source(), edits);
    if (!edited) return std::nullopt;
    const auto proof = prove(*edited, workbench_.file(), task_.id, setting_.result.tasks,
                             setting_.grader, setting_.seed + 1, setting_.clock);
    if (!proof || proof->next != next) return std::nullopt;
    return Repair{task_.id, finding_, workbench_.file(), lineEdits(workbench_.source(), edits),
                  true,     next};
}

Search& TaskExplanation::searchOf(Reach reach, Bench& bench) {
    const auto known = searches_.find(reach);
    if (known != searches_.end()) return known->second;
    return searches_
        .emplace(reach, Search{codeOf(setting_.grader, task_.id), task_, othersOfTheFunction(),
                               bench.program, setting_.seed, setting_.clock})
        .first->second;
}

std::vector<const Task*> TaskExplanation::othersOfTheFunction() const {
    const Exercise& exercise = *setting_.grader.exercise;
    const TaskEntry& own = *exercise.task(task_.id);
    std::vector<const Task*> others;
    for (const TaskReport& report : setting_.result.tasks) {
        const TaskEntry* entry = exercise.task(report.id);
        const bool isOther = entry != nullptr && entry->id != own.id && entry->file == own.file &&
                             entry->functionName() == own.functionName();
        if (isOther && report.state == TaskState::passed)
            others.push_back(&codeOf(setting_.grader, report.id));
    }
    return others;
}

Choice TaskExplanation::choice() const {
    return [this](const Atom& atom) { return !isOfAnotherTask(atom.function); };
}

bool TaskExplanation::isOfAnotherTask(const std::string& function) const {
    const Exercise& exercise = *setting_.grader.exercise;
    return std::ranges::any_of(exercise.tasks, [&](const TaskEntry& entry) {
        return entry.file == workbench_.file() && entry.functionName() == function &&
               exercise.task(task_.id)->functionName() != function;
    });
}

}  // namespace ticker::repair
