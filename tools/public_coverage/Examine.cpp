#include "Examine.h"

#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <array>
#include <cstdlib>
#include <fstream>
#include <utility>

namespace ticker::coverage {
namespace {

namespace fs = std::filesystem;

constexpr std::array kNames{"BumpySphere", "Renderer"};

std::string quoted(const fs::path& path) {
    return "'" + path.string() + "'";  // our own paths contain no quotes
}

/// Exit status of a shell command; 128 and more if a signal ended it.
int run(const std::string& command) {
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

std::vector<std::string> suitesOf(const std::string& task) {
    if (task == "T1") return {"BumpMapping"};
    if (task == "T2.1") return {"SoftShadows"};
    if (task == "T2.2") return {"DepthOfField"};
    return {"SoftShadows", "DepthOfField"};
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

Examiner::Examiner(fs::path root, fs::path linkFile)
    : root_(std::move(root)), linkFile_(std::move(linkFile)) {
    for (const std::string name : kNames)
        if (!compile(readWhole(root_ / "reference_solution/exercise" / (name + ".cpp")), name,
                     reference_.path()))
            throw raytracer::Error("the reference solution does not compile");
}

/// Writes NAME.o into the folder; false if compiling fails.
bool Examiner::compile(const std::string& text, const std::string& name,
                       const fs::path& folder) const {
    std::ofstream{folder / (name + ".cpp")} << text;
    return run("cd " + quoted(folder) + " && " TICKER_COMPILE " -std=c++20 -O1 -w -I" +
               quoted(root_ / "student_template/framework/include") + " -c " + name +
               ".cpp 2>/dev/null") == 0;
}

bool Examiner::build(const Case& one, const fs::path& folder) const {
    std::string objects;
    for (const std::string name : kNames) {
        const auto own = one.files.find(name + ".cpp");
        const bool isOwn = own != one.files.end();
        if (isOwn && !compile(own->second, name, folder)) return false;
        objects += " " + quoted((isOwn ? folder : reference_.path()) / (name + ".o"));
    }
    const std::string link = "cd " + quoted(folder) + " && " TICKER_LINK + objects + " @" +
                             quoted(linkFile_) + " -o public_tests 2>link.txt";
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
    for (const std::string& suite : suitesOf(one.task))
        filter += (filter.empty() ? "" : ":") + suite + ".*";
    // A right solution takes less than a second of CPU time.
    const int status = run("cd " + quoted(work.path()) +
                           " && ulimit -t 20 && timeout 120 ./public_tests --gtest_filter='" +
                           filter + "' --gtest_output=json:report.json >/dev/null 2>&1");
    if (status > 1) {
        outcome.kind = Outcome::Kind::crashed;
        return outcome;
    }
    return read(nlohmann::json::parse(readWhole(work.path() / "report.json")));
}

}  // namespace ticker::coverage
