#include <grader/lab/coverage/PublicExaminer.h>

#include <grader/base/JsonValue.h>
#include <grader/base/ShellQuoted.h>
#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <utility>

namespace ticker::coverage {
namespace {

namespace fs = std::filesystem;

/// Exit status of a shell command; 128 and more if a signal ended it.
int run(const std::string& command) {
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

/// The public tests' suite of each task, as the template's check.json lists them.
std::map<std::string, std::string> readSuites(const fs::path& root, const Exercise& exercise) {
    const fs::path file = root / fs::path{exercise.stubs}.parent_path() / "check.json";
    std::map<std::string, std::string> suites;
    for (const JsonValue& task :
         JsonValue::parse(readWhole(file), file.string()).at("tasks").items())
        suites[task.at("id").text()] = task.at("suite").text();
    return suites;
}

/// Whether an option has this task.
bool isOf(const std::string& task, const std::string& option, const Exercise& exercise) {
    const auto found = std::ranges::find(exercise.options, option, &OptionEntry::name);
    return found != exercise.options.end() && std::ranges::count(found->tasks, task) > 0;
}

Outcome read(const nlohmann::json& report) {
    Outcome outcome;
    std::size_t ran = 0;
    for (const auto& suite : report.at("testsuites"))
        for (const auto& test : suite.at("testsuite")) {
            if (test.at("result") == "COMPLETED") ++ran;
            if (test.contains("failures"))
                outcome.failed.push_back(test.at("name").get<std::string>());
        }
    if (ran == 0) outcome.kind = Outcome::Kind::notAttempted;
    return outcome;
}

}  // namespace

ScratchFolder::ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "public-coverage-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw raytracer::Error("no temporary folder");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

Examiner::Examiner(fs::path root, const Exercise& exercise)
    : root_(std::move(root)), exercise_(exercise), suites_(readSuites(root_, exercise)) {
    for (const std::string& file : exercise_.files())
        if (!compile(readWhole(root_ / exercise_.reference / file), fs::path{file}.stem(),
                     reference_.path()))
            throw raytracer::Error("the reference solution does not compile");
}

/// Writes NAME.o into the folder; false if compiling fails.
bool Examiner::compile(const std::string& text, const std::string& name,
                       const fs::path& folder) const {
    std::ofstream{folder / (name + ".cpp")} << text;
    return run("cd " + shellQuoted(folder.string()) +
               " && " TICKER_COMPILE " -std=c++20 -O1 -w -I" +
               shellQuoted((root_ / "student_template/framework/include").string()) + " -c " +
               name + ".cpp 2>/dev/null") == 0;
}

bool Examiner::build(const Case& one, const fs::path& folder) const {
    std::string objects;
    for (const std::string& file : exercise_.files()) {
        const std::string name = fs::path{file}.stem();
        const auto own = one.files.find(file);
        const bool isOwn = own != one.files.end();
        if (isOwn && !compile(own->second, name, folder)) return false;
        objects +=
            " " + shellQuoted(((isOwn ? folder : reference_.path()) / (name + ".o")).string());
    }
    const std::string link = "cd " + shellQuoted(folder.string()) + " && " TICKER_LINK + objects +
                             " @" + shellQuoted(TICKER_LINK_FILE) + " -o public_tests 2>link.txt";
    if (run(link) != 0) throw raytracer::Error("cannot link: " + readWhole(folder / "link.txt"));
    return true;
}

Outcome Examiner::examine(const Case& one) const {
    const ScratchFolder work;
    Outcome outcome;
    if (!build(one, work.path())) {
        outcome.kind = Outcome::Kind::doesNotCompile;
        return outcome;
    }
    std::string filter;
    for (const auto& [task, suite] : suites_)
        if (task == one.task || isOf(task, one.task, exercise_))
            filter += (filter.empty() ? "" : ":") + suite + ".*";
    // A right solution takes less than a second of CPU time.
    const int status = run("cd " + shellQuoted(work.path().string()) +
                           " && ulimit -t 20 && timeout 120 ./public_tests --gtest_filter='" +
                           filter + "' --gtest_output=json:report.json >/dev/null 2>&1");
    if (status > 1) {
        outcome.kind = Outcome::Kind::crashed;
        return outcome;
    }
    return read(nlohmann::json::parse(readWhole(work.path() / "report.json")));
}

}  // namespace ticker::coverage
