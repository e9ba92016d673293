#include "Case.h"

#include <grader/corpus/Entry.h>

#include <utility>

namespace ticker::coverage {
namespace {

using corpus::Entry;

Case caseOf(const Entry& entry) {
    Case one{"", entry.name, entry.about, true, corpus::textsOf(entry)};
    std::erase_if(one.files, [](const auto& file) { return !file.first.ends_with(".cpp"); });
    one.task = one.files.contains("BumpySphere.cpp") ? "T1" : "T2";
    return one;
}

void addCatalogue(const std::filesystem::path& root, std::vector<Case>& cases) {
    for (const Entry& entry : corpus::readCatalogue(root)) {
        cases.push_back(caseOf(entry));
        cases.back().task = entry.group;
        cases.back().right = entry.expected().passes();
    }
}

/// @param wrong  Ending of the groups of solutions on which a public test may fail.
void addWhole(const std::filesystem::path& root, const std::string& collection,
              const std::string& kind, const std::string& wrong, std::vector<Case>& cases) {
    for (const Entry& entry : corpus::readEntries(root, {collection})) {
        Case one = caseOf(entry);
        if (one.files.empty()) continue;
        one.name = kind + " " + entry.name;
        one.right = !entry.group.ends_with(wrong);
        cases.push_back(std::move(one));
    }
}

}  // namespace

std::vector<Case> listCases(const std::filesystem::path& root) {
    std::vector<Case> cases;
    addCatalogue(root, cases);
    addWhole(root, "samples", "sample", "notAwarded", cases);
    addWhole(root, "unseen", "unseen", "wrong", cases);
    return cases;
}

}  // namespace ticker::coverage
