#include <grader/cli/Home.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <cstdlib>
#include <string>
#include <vector>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

/// The first folder of a home that is not there; empty: it has all.
std::string missingIn(const fs::path& folder) {
    std::error_code ignored;
    for (const char* name : {"scenes", "assets"})
        if (!fs::is_directory(folder / name, ignored)) return name;
    return "";
}

/// The folder that the environment names; empty: none.
fs::path toldHome() {
    const char* told = std::getenv("TICKER_HOME");
    if (told == nullptr || *told == '\0') return {};
    if (const std::string missing = missingIn(told); !missing.empty())
        throw raytracer::InputError(
            std::string{"TICKER_HOME="} + told, 0,
            "has no folder " + missing + "; expected the folder of the kit's data, or no value");
    return told;
}

}  // namespace

Home Home::find() {
    std::error_code ignored;
    const fs::path programs = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    if (const fs::path told = toldHome(); !told.empty()) return {programs, told};
    std::vector<fs::path> candidates{programs.parent_path() / "share" / "ticker"};
    for (fs::path folder = programs; folder.has_relative_path(); folder = folder.parent_path())
        candidates.push_back(folder);
    for (const fs::path& candidate : candidates)
        if (missingIn(candidate).empty()) return {programs, candidate};
    throw raytracer::Error(
        fmt::format("no scenes/ and assets/ above {} nor in ../share/ticker; say where they are in "
                    "the environment's TICKER_HOME",
                    programs.string()));
}

}  // namespace ticker::cli
