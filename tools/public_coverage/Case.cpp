#include "Case.h"

#include <grader/corpus/Catalogue.h>

#include <grader/base/WholeFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <utility>

namespace ticker::coverage {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> foldersIn(const fs::path& folder) {
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.is_directory()) found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

void addCatalogue(const fs::path& root, std::vector<Case>& cases) {
    for (const mistakes::Mistake& mistake : mistakes::readCatalogue(root / "grader/corpus")) {
        const std::string reference =
            readWhole(root / "reference_solution/exercise" / mistake.file);
        cases.push_back({mistake.task,
                         mistake.id,
                         mistake.title,
                         mistake.expect.state == TaskState::passed,
                         {{mistake.file, mistakes::makeMistake(mistake, reference)}}});
    }
}

/// A folder with one submission's files; false where it holds none of them.
bool addFolder(const fs::path& folder, const std::string& kind, std::string title, bool right,
               std::vector<Case>& cases) {
    Case found{"", kind + " " + folder.filename().string(), std::move(title), right, {}};
    for (const char* name : {"BumpySphere.cpp", "Renderer.cpp"})
        if (fs::is_regular_file(folder / name)) found.files[name] = readWhole(folder / name);
    if (found.files.empty()) return false;
    found.task = found.files.contains("BumpySphere.cpp") ? "T1" : "T2";
    cases.push_back(std::move(found));
    return true;
}

std::string firstLineOf(const fs::path& file) {
    std::ifstream stream{file};
    std::string line;
    std::getline(stream, line);
    return line;
}

void addSamples(const fs::path& root, std::vector<Case>& cases) {
    for (const fs::path& verdict : foldersIn(root / "grader/corpus/samples"))
        for (const fs::path& sample : foldersIn(verdict))
            addFolder(sample, "sample", firstLineOf(sample / "README.txt"),
                      verdict.filename() != "notAwarded", cases);
}

void addUnseen(const fs::path& root, std::vector<Case>& cases) {
    for (const fs::path& task : foldersIn(root / "grader/corpus/unseen"))
        for (const fs::path& merit : foldersIn(task))
            for (const fs::path& solution : foldersIn(merit))
                addFolder(solution, "unseen",
                          nlohmann::json::parse(readWhole(solution / "expected.json")).at("why"),
                          merit.filename() == "right", cases);
}

}  // namespace

std::vector<Case> listCases(const fs::path& root) {
    std::vector<Case> cases;
    addCatalogue(root, cases);
    addSamples(root, cases);
    addUnseen(root, cases);
    return cases;
}

}  // namespace ticker::coverage
