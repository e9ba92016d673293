#ifndef TICKER_TESTS_SUPPORT_FILES_H
#define TICKER_TESTS_SUPPORT_FILES_H

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace ticker::tests {

/// The bytes of a file of the project. @param name  Path from the project's root.
inline std::string readFile(const std::string& name) {
    const std::filesystem::path file = std::filesystem::path{TICKER_SOURCE_DIR} / name;
    std::ifstream stream{file, std::ios::binary};
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>{stream}, {}};
}

}  // namespace ticker::tests

#endif
