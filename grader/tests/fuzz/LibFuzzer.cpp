// Entry point for libFuzzer.
#include "Fuzz.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>

namespace {

namespace fs = std::filesystem;

void writeSeeds(const fs::path& folder) {
    int number = 0;
    for (const std::string& seed : ticker::fuzz::seeds())
        std::ofstream{folder / ("seed-" + std::to_string(number++)), std::ios::binary} << seed;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(const int* count, char*** words) {
    for (int i = 1; i < *count; ++i)
        if (const fs::path folder{(*words)[i]}; fs::is_directory(folder) && fs::is_empty(folder))
            writeSeeds(folder);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static_cast<void>(ticker::fuzz::give({reinterpret_cast<const char*>(bytes), size}));
    return 0;
}
