#ifndef TICKER_TESTS_SUPPORT_FILES_H
#define TICKER_TESTS_SUPPORT_FILES_H

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace ticker::tests {

/// The bytes of a file of the project. @param name  Path from the project's root.
inline std::string readFile(const std::string& name) {
    const std::filesystem::path file = std::filesystem::path{TICKER_SOURCE_DIR} / name;
    std::ifstream stream{file, std::ios::binary};
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>{stream}, {}};
}

/// Every Markdown file of the project, except those that builds and tools create.
inline std::vector<std::filesystem::path> documents() {
    const std::set<std::string> foreign{"build", "out", "node_modules"};
    std::vector<std::filesystem::path> found;
    for (auto at = std::filesystem::recursive_directory_iterator{TICKER_SOURCE_DIR};
         at != std::filesystem::recursive_directory_iterator{}; ++at) {
        const std::string name = at->path().filename();
        if (at->is_directory() && (foreign.contains(name) || name.starts_with(".git")))
            at.disable_recursion_pending();
        else if (at->path().extension() == ".md")
            found.push_back(at->path());
    }
    return found;
}

}  // namespace ticker::tests

#endif
