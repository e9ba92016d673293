#include "Examine.h"

#include <raytracer/base/Error.h>

#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <cstdlib>
#include <fstream>

namespace ticker::coverage {
namespace {

namespace fs = std::filesystem;

class ScratchFolder {
public:
    ScratchFolder() {
        std::string name = (fs::temp_directory_path() / "public-coverage-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw raytracer::Error("no temporary folder");
        path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

std::string quoted(const fs::path& path) {
    return "'" + path.string() + "'";  // our own paths hold no quotes
}

/// The exit status of a shell command; 128 and more where a signal ended it.
int run(const std::string& command) {
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

/// Compiles the case's files, or the reference's, and links them; false where that fails.
bool build(const Case& one, const fs::path& root, const fs::path& linkFile, const fs::path& work) {
    const std::string include = " -I" + quoted(root / "student_template/framework/include");
    for (const char* name : {"BumpySphere", "Renderer"}) {
        const std::string file = std::string{name} + ".cpp";
        const auto own = one.files.find(file);
        std::ofstream{work / file}
            << (own != one.files.end() ? own->second
                                       : readText(root / "reference_solution/exercise" / file));
        if (run("cd " + quoted(work) + " && " TICKER_COMPILE " -std=c++20 -O1 -w" + include +
                " -c " + file + " 2>/dev/null") != 0)
            return false;
    }
    const std::string link = "cd " + quoted(work) +
                             " && " TICKER_LINK " BumpySphere.o Renderer.o @" + quoted(linkFile) +
                             " -o public_tests 2>link.txt";
    if (run(link) != 0) throw raytracer::Error("cannot link: " + readText(work / "link.txt"));
    return true;
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

Outcome examine(const Case& one, const fs::path& root, const fs::path& linkFile) {
    const ScratchFolder work;
    Outcome outcome;
    if (!build(one, root, linkFile, work.path())) {
        outcome.kind = Outcome::Kind::doesNotCompile;
        return outcome;
    }
    std::string filter;
    for (const std::string& suite : suitesOf(one.task))
        filter += (filter.empty() ? "" : ":") + suite + ".*";
    // The limit of ./check.
    const int status =
        run("cd " + quoted(work.path()) + " && timeout 60 ./public_tests --gtest_filter='" +
            filter + "' --gtest_output=json:report.json >/dev/null 2>&1");
    if (status > 1) {
        outcome.kind = Outcome::Kind::crashed;
        return outcome;
    }
    return read(nlohmann::json::parse(readText(work.path() / "report.json")));
}

}  // namespace ticker::coverage
