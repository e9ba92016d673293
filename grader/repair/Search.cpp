#include <grader/repair/Search.h>

#include <grader/base/CpuTime.h>
#include <grader/repair/TaskLookup.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>
#include <variant>

namespace ticker::repair {
namespace {

using probe::Run;

// Sets that are asked in one process.
constexpr std::size_t kTogether = 200;
constexpr std::size_t kJudgedTogether = 16;

/// Notes what a judge asks first, and answers nothing.
class FirstQuestions final : public probe::Examinee {
public:
    [[nodiscard]] Run ask(const std::vector<probe::Question>& questions) override {
        if (asked.empty()) asked = questions;
        return {{}, {probe::ProcessEnd::Kind::ourFault, "not asked"}};
    }
    std::vector<probe::Question> asked;
};

template <class Value>
bool sameBytes(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

struct Same {
    bool operator()(const probe::NormalAnswer& a, const probe::NormalAnswer& b) const {
        return a.exceptions == b.exceptions && sameBytes(a.normals, b.normals);
    }
    bool operator()(const probe::IlluminateAnswer& a, const probe::IlluminateAnswer& b) const {
        return a.exceptions == b.exceptions && sameBytes(a.colours, b.colours) &&
               sameBytes(a.events, b.events);
    }
    bool operator()(const probe::RenderAnswer& a, const probe::RenderAnswer& b) const {
        return a.exceptions == b.exceptions && a.wrongSize == b.wrongSize &&
               std::ranges::equal(a.images, b.images, sameBytes<probe::ColourRGB>) &&
               sameBytes(a.events, b.events);
    }
    template <class A, class B>
    bool operator()(const A& /*a*/, const B& /*b*/) const {
        return false;
    }
};

/// Whether an edit changes no bit of what was answered.
bool sameAnswers(const Run& a, const Run& b) {
    return a.end.kind == b.end.kind &&
           std::ranges::equal(a.answers, b.answers, [](const auto& one, const auto& other) {
               return std::visit(Same{}, one, other);
           });
}

bool isFinished(const Run& run) {
    return run.end.kind == probe::ProcessEnd::Kind::finished;
}

}  // namespace

Search::Search(const Task& task, const SwitchedProgram& program, std::uint64_t seed)
    : task_(task), program_(program), seed_(seed), startMs_(threadCpuMs() + program.cpuMs()) {
    FirstQuestions recorder;
    static_cast<void>(task.judge(recorder, seed));
    first_ = std::move(recorder.asked);
    if (task.screen != nullptr) screening_ = task.screen(seed);
    const EditSet none[] = {{}};
    asHandedIn_ = program.ask(first_, none).front();
    if (screening_.mayPass) screenedAsHandedIn_ = program.ask(screening_.questions, none).front();
}

double Search::spentMs() const {
    return threadCpuMs() + program_.cpuMs() - startMs_;
}

std::vector<EditSet> Search::screened(std::span<const EditSet> sets, double deadlineMs) {
    if (!screening_.mayPass) return {sets.begin(), sets.end()};
    const bool isSeen = !screening_.mayPass(screenedAsHandedIn_);
    std::vector<EditSet> kept;
    for (std::size_t at = 0; at < sets.size() && spentMs() < deadlineMs; at += kTogether) {
        const auto some = sets.subspan(at, std::min(kTogether, sets.size() - at));
        const std::vector<Run> runs = program_.ask(screening_.questions, some);
        asked_ += some.size();
        for (std::size_t i = 0; i < some.size(); ++i) {
            if (!isFinished(runs[i])) continue;
            if (isSeen && sameAnswers(runs[i], screenedAsHandedIn_)) continue;
            if (screening_.mayPass(runs[i])) kept.push_back(some[i]);
        }
    }
    return kept;
}

bool Search::judge(const EditSet& set, Run first) const {
    EditedExaminee examinee{program_, set};
    examinee.expect(std::move(first));
    return passes(task_.judge(examinee, seed_));
}

std::vector<EditSet> Search::passing(std::span<const EditSet> sets, double deadlineMs) {
    const std::vector<EditSet> kept = screened(sets, deadlineMs);
    std::vector<EditSet> found;
    for (std::size_t at = 0; at < kept.size() && spentMs() < deadlineMs; at += kJudgedTogether) {
        const auto some = std::span{kept}.subspan(at, std::min(kJudgedTogether, kept.size() - at));
        std::vector<Run> runs = program_.ask(first_, some);
        for (std::size_t i = 0; i < some.size() && spentMs() < deadlineMs; ++i)
            if (isFinished(runs[i]) && !sameAnswers(runs[i], asHandedIn_) &&
                judge(some[i], std::move(runs[i])))
                found.push_back(some[i]);
    }
    return found;
}

}  // namespace ticker::repair
