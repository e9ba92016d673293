#include <grader/intake/MoodleExport.h>

#include <grader/intake/Contents.h>

#include <set>
#include <system_error>

namespace ticker::intake {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kSubmission = "_assignsubmission_";

// Moodle turns underscores of names into spaces, so the first mark is Moodle's own.
//   folders      Ann Lee_123_assignsubmission_file/src/Renderer.cpp
//   before 4.1   Ann Lee_123_assignsubmission_file_/src/Renderer.cpp
//   flat         Ann Lee_123_assignsubmission_file_Renderer.cpp
std::optional<MoodleFile> readFrom(std::string_view path) {
    const std::size_t mark = path.substr(0, path.find('/')).find(kSubmission);
    if (mark == std::string_view::npos || mark == 0) return std::nullopt;
    std::string_view rest = path.substr(mark + kSubmission.size());
    const std::size_t end = rest.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
    const std::string_view plugin = rest.substr(0, end);
    rest.remove_prefix(plugin.size());
    if (plugin.empty() || (!rest.empty() && rest[0] != '_' && rest[0] != '/')) return std::nullopt;
    if (rest.starts_with('_')) rest.remove_prefix(1);
    if (rest.starts_with('/')) rest.remove_prefix(1);
    MoodleFile file{std::string{path.substr(0, mark)}, std::string{rest}};
    if (plugin != "file" && !rest.empty()) file.path = std::string{plugin} + "/" + file.path;
    return file;
}

std::vector<std::string> pathsIn(const fs::path& exported) {
    std::error_code error;
    if (!fs::is_directory(exported, error)) return listArchive(exported);
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator{exported, error})
        names.push_back(entry.path().filename().string());
    return names;
}

}  // namespace

std::optional<MoodleFile> readMoodlePath(std::string_view path) {
    if (isLitter(path)) return std::nullopt;
    if (auto file = readFrom(path)) return file;
    const std::size_t slash = path.find('/');
    return slash == std::string_view::npos ? std::nullopt : readFrom(path.substr(slash + 1));
}

std::vector<std::string> moodleOwners(const fs::path& exported) {
    std::set<std::string> owners;
    for (const std::string& path : pathsIn(exported))
        if (const auto file = readMoodlePath(path)) owners.insert(file->owner);
    return {owners.begin(), owners.end()};
}

}  // namespace ticker::intake
