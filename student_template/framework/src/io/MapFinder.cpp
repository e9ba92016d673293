#include "MapFinder.h"

#include <raytracer/io/PathOf.h>

#include <algorithm>
#include <system_error>

namespace raytracer {
namespace {

namespace fs = std::filesystem;

bool leadsOutside(const fs::path& name) {
    return name.has_root_path() ||
           std::find(name.begin(), name.end(), fs::path("..")) != name.end();
}

bool liesIn(const fs::path& folder, const fs::path& file) {
    const auto [inFolder, inFile] =
        std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    return inFolder == folder.end();
}

std::string listed(const std::vector<fs::path>& folders) {
    std::string text;
    for (const fs::path& folder : folders)
        text += (text.empty() ? "" : " or ") + folder.string();
    return text;
}

}  // namespace

MapFinder::MapFinder(const std::vector<fs::path>& folders) {
    for (const fs::path& folder : folders)
        if (!folder.empty()) folders_.push_back(folder);
}

MapFinder::Result MapFinder::find(const std::string& name) const {
    if (name.empty()) return {{}, "the name of a PNG file"};
    const fs::path relative = pathOf(name);
    if (leadsOutside(relative))
        return {{},
                "a name without \"..\" that does not begin with \"/\", of a file in " +
                    listed(folders_)};
    for (const fs::path& folder : folders_) {
        std::error_code error;
        const fs::path file = folder / relative;
        if (!fs::is_regular_file(file, error)) continue;
        const fs::path real = fs::canonical(file, error);
        if (error) continue;
        const fs::path realFolder = fs::canonical(folder, error);
        if (error || !liesIn(realFolder, real))
            return {
                {},
                "a file that lies in " + folder.string() + " itself; this one is a link out of it"};
        return {file, {}};
    }
    return {{}, "the name of a PNG file in " + listed(folders_)};
}

}  // namespace raytracer
