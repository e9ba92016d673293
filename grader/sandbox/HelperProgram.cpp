#include <grader/sandbox/HelperProgram.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace ticker::sandbox {
namespace fs = std::filesystem;

fs::path findProgram(const std::string& name) {
    std::error_code error;
    const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
    const fs::path beside = folder / name;
    const fs::path installed = folder.parent_path() / "libexec" / "ticker" / name;
    for (const fs::path& candidate : {beside, installed})
        if (access(candidate.c_str(), X_OK) == 0) return candidate;
    throw raytracer::Error(
        fmt::format("sandbox: the helper {0} is missing: neither {1} nor {2} is there; build the "
                    "target {0}",
                    name, beside.string(), installed.string()));
}

std::string cannotStage(const fs::path& what, const std::error_code& why) {
    return fmt::format(
        "sandbox: cannot copy {} to the temporary disk: {}; free some space there, or set TMPDIR "
        "to a folder with room",
        what.string(), why.message());
}

fs::path copyProgram(const std::string& name, const fs::path& folder) {
    const fs::path original = findProgram(name);
    fs::path copy = folder / name;
    std::error_code error;
    fs::copy_file(original, copy, error);
    if (!error) fs::permissions(copy, fs::perms{0755}, error);
    if (error) throw raytracer::Error(cannotStage(original, error));
    return copy;
}

fs::path findBubblewrap() {
    std::vector<fs::path> folders{"/usr/bin", "/usr/local/bin", "/bin"};
    // NOLINTNEXTLINE(concurrency-mt-unsafe): read once, before threads write the environment.
    if (const char* list = std::getenv("PATH")) {
        std::istringstream words{list};
        for (std::string word; std::getline(words, word, ':');)
            folders.emplace_back(word);
    }
    for (const fs::path& folder : folders) {
        if (folder.is_relative()) continue;
        const fs::path candidate = folder / "bwrap";
        if (access(candidate.c_str(), X_OK) == 0) return candidate;
    }
    return {};
}

}  // namespace ticker::sandbox
