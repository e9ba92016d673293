#include <grader/similar/Matcher.h>

#include <grader/sandbox/JobFolder.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <iterator>
#include <regex>
#include <sstream>
#include <system_error>

namespace ticker::similar {
namespace {

namespace fs = std::filesystem;

// The shortest run of tokens that counts. Measured: 12 tokens are shared by chance too often.
constexpr const char* kShortestRun = "16";

int number(const std::ssub_match& match) {
    return std::stoi(match.str());
}

/// Calls `use` with each line of `text` that the pattern matches.
template <class Use>
void forEachMatch(const std::string& text, const char* pattern, Use use) {
    const std::regex wanted{pattern};
    std::istringstream stream{text};
    std::smatch match;
    for (std::string line; std::getline(stream, line);)
        if (std::regex_search(line, match, wanted)) use(match);
}

std::vector<Match> matchesIn(const std::string& output) {
    std::vector<Match> matches;
    forEachMatch(output, R"(^(\d+)\.cpp: line (\d+)-(\d+) *\|(\d+)\.cpp: line (\d+)-(\d+) *\[)",
                 [&](const std::smatch& match) {
                     matches.push_back({static_cast<std::size_t>(number(match[1])),
                                        static_cast<std::size_t>(number(match[4])),
                                        {{number(match[2]), number(match[3])},
                                         {number(match[5]), number(match[6])}}});
                 });
    return matches;
}

std::string howItEnded(const sandbox::Outcome& outcome, const sandbox::Limits& limits) {
    using End = sandbox::Outcome::End;
    switch (outcome.end) {
        case End::exited:
            return fmt::format("exit status {}", outcome.code);
        case End::signalled:
            return outcome.code == SIGXCPU
                       ? fmt::format("stopped after {:.0f} s of the processor", limits.cpuSeconds)
                       : fmt::format("killed by signal {}", outcome.code);
        case End::wallLimit:
            return fmt::format("stopped after {:.0f} s", limits.wallSeconds);
        case End::outputLimit:
            return fmt::format("stopped after {} bytes of output", limits.outputBytes);
        case End::failed:
            break;
    }
    return "the sandbox failed";
}

}  // namespace

fs::path findMatcher() {
    std::error_code error;
    const fs::path program = "/usr/bin/sim_c++";
    return fs::exists(program, error) ? program : fs::path{};
}

std::string matcherFailure(std::size_t files, const sandbox::Outcome& outcome,
                           const sandbox::Limits& limits) {
    std::string text =
        fmt::format("sim_c++ did not finish on {} files ({})", files, howItEnded(outcome, limits));
    if (!outcome.output.empty()) text += ": " + outcome.output.substr(0, 400);
    return text;
}

Matcher::Matcher(const sandbox::Sandbox& sandbox, const sandbox::Limits& limits)
    : sandbox_(sandbox), limits_(limits) {
    if (findMatcher().empty())
        throw raytracer::InputError("sim_c++", 0,
                                    "is not installed; please run: sudo apt-get install "
                                    "similarity-tester");
}

std::string Matcher::run(const std::vector<std::string>& options,
                         const std::vector<std::string>& texts,
                         const std::vector<std::string>& known) const {
    const sandbox::JobFolder folder;
    sandbox::Command command;
    command.arguments = {findMatcher().string(), "-T", "-w", "200", "-r", kShortestRun};
    std::ranges::copy(options, std::back_inserter(command.arguments));
    for (std::size_t i = 0; i < texts.size() + known.size(); ++i) {
        const std::string name = fmt::format("{:05}.cpp", i);
        folder.write(name, i < texts.size() ? texts[i] : known[i - texts.size()]);
        if (i == texts.size()) command.arguments.emplace_back("/");
        command.arguments.push_back(name);
    }
    command.folder = "/texts";
    command.readOnly = {{"/usr", "/usr"}, {folder.path(), "/texts"}};
    command.policy = sandbox::Policy::compile;
    command.limits = limits_;
    sandbox::Outcome outcome = sandbox_.run(command);
    if (!outcome.succeeded())
        throw raytracer::Error(
            matcherFailure(texts.size() + known.size(), outcome, command.limits));
    return std::move(outcome.output);
}

std::vector<Match> Matcher::against(const std::vector<std::string>& texts,
                                    const std::vector<std::string>& known) const {
    std::vector<Match> matches = matchesIn(run({"-n", "-S"}, texts, known));
    for (Match& match : matches)
        match.right -= texts.size();
    return matches;
}

std::vector<Passage> Matcher::between(const std::string& left, const std::string& right) const {
    std::vector<Passage> passages;
    for (Match& match : matchesIn(run({"-n", "-s"}, {left, right}))) {
        if (match.left > match.right) std::swap(match.passage.left, match.passage.right);
        passages.push_back(match.passage);
    }
    std::ranges::sort(passages, {}, [](const Passage& one) { return one.left.first; });
    return passages;
}

std::vector<Share> Matcher::shares(const std::vector<std::string>& texts) const {
    std::vector<Share> shares;
    forEachMatch(
        run({"-p", "-a", "-e"}, texts),
        R"(^(\d+)\.cpp consists for (\d+) % of (\d+)\.cpp material)",
        [&](const std::smatch& match) {
            shares.push_back({static_cast<std::size_t>(number(match[1])),
                              static_cast<std::size_t>(number(match[3])), number(match[2])});
        });
    return shares;
}

}  // namespace ticker::similar
