#include <grader/lab/coverage/PublicCase.h>

#include <grader/corpus/Entry.h>

#include <utility>

namespace ticker::coverage {
namespace {

using corpus::Entry;

/// The option whose tasks are solved in one of these files.
std::string optionOf(const std::map<std::string, std::string>& files, const Exercise& exercise) {
    for (const OptionEntry& option : exercise.options)
        for (const auto& [file, text] : files)
            if (exercise.isIn(option.name, file)) return option.name;
    return {};
}

Case caseOf(const Entry& entry, const Exercise& exercise) {
    Case one{"", entry.name, entry.about, true, corpus::textsOf(entry)};
    std::erase_if(one.files, [](const auto& file) { return !file.first.ends_with(".cpp"); });
    one.task = optionOf(one.files, exercise);
    return one;
}

void addCatalogue(const std::filesystem::path& root, const Exercise& exercise,
                  std::vector<Case>& cases) {
    for (const Entry& entry : corpus::readCatalogue(root, exercise)) {
        cases.push_back(caseOf(entry, exercise));
        cases.back().task = entry.group;
        cases.back().right = entry.expected().passes();
    }
}

/// @param wrong  Ending of the groups of solutions on which a public test may fail.
void addWhole(const std::filesystem::path& root, const Exercise& exercise,
              const std::string& collection, const std::string& kind, const std::string& wrong,
              std::vector<Case>& cases) {
    for (const Entry& entry : corpus::readEntries(root, {collection}, exercise)) {
        Case one = caseOf(entry, exercise);
        if (one.files.empty()) continue;
        one.name = kind + " " + entry.name;
        one.right = !entry.group.ends_with(wrong);
        cases.push_back(std::move(one));
    }
}

}  // namespace

std::vector<Case> listCases(const std::filesystem::path& root, const Exercise& exercise) {
    std::vector<Case> cases;
    addCatalogue(root, exercise, cases);
    addWhole(root, exercise, "samples", "sample", "notAwarded", cases);
    addWhole(root, exercise, "unseen", "unseen", "wrong", cases);
    return cases;
}

}  // namespace ticker::coverage
