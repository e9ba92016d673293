#ifndef TICKER_TESTS_IO_BYTESOF_H
#define TICKER_TESTS_IO_BYTESOF_H

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace ticker::testing {

inline std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace ticker::testing

#endif
