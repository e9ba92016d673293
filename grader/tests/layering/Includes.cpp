#include <grader/tests/layering/Includes.h>

#include <algorithm>
#include <fstream>
#include <regex>

namespace ticker::tests {
namespace {

namespace fs = std::filesystem;

const fs::path kTop{TICKER_SOURCE_DIR};

/// Tables of findings are in their tasks' folders, but belong below all code: pipeline reads them,
/// too.
bool isTableOfFindings(const std::string& file) {
    return fs::path{file}.stem().string().ends_with("Findings");
}

}  // namespace

std::optional<std::string> layerOf(const fs::path& file) {
    std::vector<std::string> parts;
    for (const fs::path& part : fs::relative(file, kTop))
        parts.push_back(part.string());
    const auto at = [&](std::size_t i) { return i < parts.size() ? parts[i] : std::string{}; };
    if (at(0) == "student_template" && at(1) == "framework") {
        if (at(2) == "app") return "app";
        return "raytracer/" + (at(2) == "include" ? at(4) : at(3));
    }
    if (at(0) == "student_template" && at(1) == "tests" && at(2) == "questions") return "questions";
    if (at(0) != "grader" && at(1) == "exercise") return "exercise";
    if (at(1) == "tasks" && isTableOfFindings(file.filename().string())) return "findings";
    const bool isSubmission = at(1) == "corpus" && parts.size() > 3;
    if (at(0) == "grader" && at(1) != "tests" && at(1) != "bench" && at(1) != "integrations" &&
        !isSubmission)
        return "grader/" + at(1) + (at(1) == "tasks" && parts.size() > 3 ? "/" + at(2) : "");
    return std::nullopt;
}

std::optional<std::string> folderOf(const std::string& header) {
    static const std::regex kOurs{R"(^(grader/tasks/[a-z]+|(raytracer|grader)/[a-z]+)/.*)"};
    std::smatch match;
    if (header.starts_with("grader/tasks/") && isTableOfFindings(header)) return "findings";
    if (std::regex_match(header, match, kOurs)) return match[1];
    if (header.starts_with("questions/")) return "questions";
    return std::nullopt;
}

std::vector<fs::path> sources() {
    std::vector<fs::path> files;
    for (const char* top : {"student_template", "reference_solution", "grader", "tools"})
        for (const auto& entry : fs::recursive_directory_iterator{kTop / top})
            if (entry.is_regular_file() &&
                (entry.path().extension() == ".h" || entry.path().extension() == ".cpp"))
                files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> linesOf(const fs::path& file) {
    std::ifstream stream{file};
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

std::vector<std::string> includesOf(const fs::path& file) {
    static const std::regex kInclude{R"(^\s*#\s*include\s*[<"]([^>"]+)[>"].*)"};
    std::vector<std::string> headers;
    for (const std::string& line : linesOf(file)) {
        std::smatch match;
        if (std::regex_match(line, match, kInclude)) headers.push_back(match[1]);
    }
    return headers;
}

}  // namespace ticker::tests
