#include <grader/repair/Search.h>

#include <grader/repair/AskedQuestions.h>
#include <grader/repair/SameAnswers.h>
#include <grader/repair/TaskLookup.h>
#include <grader/result/GeneralFindings.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace ticker::repair {
namespace {

using probe::Run;

// Sets that are asked in one process. Where the cheap questions show the mistake, a few come first,
// since what passed is judged only after all of them.
constexpr std::size_t kScreenedFirst = 25;
constexpr std::size_t kScreenedTogether = 200;
constexpr std::size_t kJudgedFirst = 4;
constexpr std::size_t kJudgedTogether = 16;

std::vector<probe::Question> firstQuestions(const Task& task, std::uint64_t seed) {
    FirstQuestions examinee;
    static_cast<void>(task.judge(examinee, seed));
    return std::move(examinee.asked);
}

/// The first of both, then the second of both, and so on.
std::vector<EditSet> inTurn(const std::vector<EditSet>& some, const std::vector<EditSet>& others) {
    std::vector<EditSet> all;
    for (std::size_t i = 0; i < std::max(some.size(), others.size()); ++i) {
        if (i < some.size()) all.push_back(some[i]);
        if (i < others.size()) all.push_back(others[i]);
    }
    return all;
}

bool isFinished(const Run& run) {
    return run.end.kind == probe::ProcessEnd::Kind::finished;
}

}  // namespace

Search::Search(const Task& task, const TaskJudgement& before,
               const std::vector<const Task*>& others, SwitchedProgram& program, std::uint64_t seed,
               const Clock& clock)
    : task_(task),
      before_(before),
      judge_(judgeOfMany(task)),
      program_(program),
      seed_(seed),
      clock_(clock),
      first_(firstQuestions(task, seed)),
      asHandedIn_(EditedExaminee{program, {}}.ask(first_)) {
    for (const Task* other : others)
        others_.push_back(judgeOfMany(*other));
    program.answersUnedited(isFinished(asHandedIn_));
    if (task.screen != nullptr) drawScreening();
    if (!isSeen_) findDeciding();
}

void Search::findDeciding() {
    EditedExaminee asHandedIn{program_, {}};
    asHandedIn.expect(asHandedIn_);
    LastQuestions examinee{asHandedIn};
    static_cast<void>(judge_(examinee, seed_));
    if (examinee.count < 2) return;
    deciding_ = std::move(examinee.last);
    decidedAsHandedIn_ = std::move(examinee.run);
}

bool Search::takeScreening(Screening drawn) {
    Run run = EditedExaminee{program_, {}}.ask(drawn.questions);
    isSeen_ = !drawn.mayPass(run);
    if (!screening_.mayPass || isSeen_) {
        if (screening_.mayPass) passed_ = std::move(screening_);  // the first that were drawn
        screening_ = std::move(drawn);
        screenedAsHandedIn_ = std::move(run);
    }
    return isSeen_;
}

void Search::drawScreening() {
    // Few answers may show the mistake, so that cheap questions of other seeds, and then of other
    // kinds, are tried. If none of them shows it, the first ones are as good as the others.
    constexpr std::uint64_t kMostDraws = 4;
    for (std::uint64_t i = 0; i < kMostDraws && !clock_.isStepOver(); ++i)
        if (takeScreening(task_.screen(seed_ + i))) return;
    if (task_.screenElsewhere == nullptr) return;
    for (Screening& other : task_.screenElsewhere(seed_)) {
        if (clock_.isStepOver()) return;
        if (takeScreening(std::move(other))) return;
    }
}

// Most edits fail the first cheap questions. Other ones may take ten times as long to answer.
std::vector<EditSet> Search::stillPassing(std::span<const EditSet> sets) {
    if (!passed_.mayPass) return {sets.begin(), sets.end()};
    std::vector<EditSet> kept;
    program_.askEach(passed_.questions, sets, [&](std::size_t i, const Run& run) {
        ++asked_;
        if (!isFinished(run))
            idle_.insert(sets[i]);
        else if (passed_.mayPass(run))
            kept.push_back(sets[i]);
    });
    return kept;
}

std::vector<EditSet> Search::screened(std::span<const EditSet> drawn) {
    if (!screening_.mayPass) return {drawn.begin(), drawn.end()};
    const std::vector<EditSet> sets = stillPassing(drawn);
    std::vector<EditSet> kept;
    std::vector<EditSet> alike;
    program_.askEach(screening_.questions, sets, [&](std::size_t i, const Run& run) {
        if (!passed_.mayPass) ++asked_;
        const bool isAlike = isFinished(run) && sameAnswers(run, screenedAsHandedIn_);
        if (isSeen_ && (isAlike || !isFinished(run))) idle_.insert(sets[i]);
        if (!isFinished(run) || (isSeen_ && isAlike)) return;
        if (isAlike)
            alike.push_back(sets[i]);
        else if (screening_.mayPass(run))
            kept.push_back(sets[i]);
    });
    // If the submission passes the cheap questions, an edit that changes no answer to them is as
    // likely to mend it as one that does.
    return inTurn(alike, kept);
}

TaskJudgement Search::judge(const EditSet& set, Run first) const {
    EditedExaminee examinee{program_, set};
    examinee.expect(std::move(first));
    return judge_(examinee, seed_);
}

bool Search::passesOthers(const EditSet& set) const {
    return std::ranges::all_of(others_, [&](const Judge& other) {
        EditedExaminee examinee{program_, set};
        return passes(other(examinee, seed_));
    });
}

std::vector<std::optional<Run>> Search::firstRuns(std::span<const EditSet> sets) const {
    std::vector<std::optional<Run>> changed(sets.size());
    std::vector<std::size_t> alike;
    std::vector<EditSet> alikeSets;
    std::vector<Run> runs = program_.ask(first_, sets);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (!isFinished(runs[i])) continue;
        if (sameAnswers(runs[i], asHandedIn_)) {
            alike.push_back(i);
            alikeSets.push_back(sets[i]);
        } else {
            changed[i] = std::move(runs[i]);
        }
    }
    if (deciding_.empty()) return changed;
    program_.askEach(deciding_, alikeSets, [&](std::size_t i, const Run& run) {
        if (isFinished(run) && !sameAnswers(run, decidedAsHandedIn_))
            changed[alike[i]] = std::move(runs[alike[i]]);
    });
    return changed;
}

template <class Use>
bool Search::judgeEach(std::span<const EditSet> sets, Use use) {
    // What passes cheap questions that the submission fails is worth the time of a later step.
    const auto hasTime = [&] { return isSeen_ ? !clock_.isAllUsedUp() : !clock_.isStepOver(); };
    // A few at first: the simplest ones pass more often than others.
    std::size_t together = kJudgedFirst;
    for (std::size_t at = 0; at < sets.size() && hasTime();) {
        const auto some = sets.subspan(at, std::min(together, sets.size() - at));
        at += some.size();
        together = std::min(2 * together, kJudgedTogether);
        std::vector<std::optional<Run>> runs = firstRuns(some);
        for (std::size_t i = 0; i < runs.size() && hasTime(); ++i)
            if (runs[i] && !use(some[i], judge(some[i], *std::move(runs[i])))) return false;
    }
    return true;
}

void Search::eachPassing(std::span<const EditSet> sets,
                         const std::function<bool(const EditSet&)>& use) {
    // Sets that pass the screening are judged before more are screened, since the time may run out.
    const auto judged = [&](const EditSet& set, const TaskJudgement& judgement) {
        const bool isClean = passes(judgement) && !addsWarning(judgement, before_);
        return !isClean || !passesOthers(set) || use(set);
    };
    std::vector<EditSet> later;
    std::size_t together = isSeen_ ? kScreenedFirst : kScreenedTogether;
    for (std::size_t at = 0; at < sets.size() && !clock_.isStepOver();) {
        const auto some = sets.subspan(at, std::min(together, sets.size() - at));
        at += some.size();
        together = std::min(2 * together, kScreenedTogether);
        std::vector<EditSet> kept = screened(some);
        // Where the cheap questions do not see the mistake, most edits pass them.
        if (!isSeen_ && screening_.mayPass && kept.size() > kJudgedTogether) {
            const auto end = kept.begin() + static_cast<std::ptrdiff_t>(kJudgedTogether);
            later.insert(later.end(), end, kept.end());
            kept.erase(end, kept.end());
        }
        if (!judgeEach(kept, judged)) return;
    }
    judgeEach(later, judged);
}

std::vector<Partial> Search::changing(std::span<const EditSet> sets, const std::string& finding) {
    std::vector<Partial> found;
    std::map<std::string, int> leading;
    judgeEach(sets, [&](const EditSet& set, const TaskJudgement& judgement) {
        const std::string next = firstFailure(judgement);
        // A finding named after a mistake explains all answers that are left, so the edit mended
        // another mistake.
        const bool isNamed = !isRunEnd(next) && !next.ends_with(".wrong");
        if (!next.empty() && next != finding && isNamed) {
            found.push_back({set, next, failuresOf(judgement)});
            ++leading[next];
        }
        return true;
    });
    std::ranges::stable_sort(found, {}, [&](const Partial& one) { return leading[one.next]; });
    return found;
}

}  // namespace ticker::repair
