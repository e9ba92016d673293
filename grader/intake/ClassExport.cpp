#include <grader/intake/ClassExport.h>

#include <grader/intake/CanvasName.h>
#include <grader/intake/Contents.h>

#include <fmt/core.h>

#include <set>
#include <system_error>
#include <utility>

namespace ticker::intake {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kSubmission = "_assignsubmission_";

// Moodle turns underscores of names into spaces, so the first mark is Moodle's own.
//   folders      Ann Lee_123_assignsubmission_file/src/File.cpp
//   before 4.1   Ann Lee_123_assignsubmission_file_/src/File.cpp
//   flat         Ann Lee_123_assignsubmission_file_File.cpp
std::optional<ExportedFile> readMoodlePath(std::string_view path) {
    const std::size_t mark = path.substr(0, path.find('/')).find(kSubmission);
    if (mark == std::string_view::npos || mark == 0) return std::nullopt;
    std::string_view rest = path.substr(mark + kSubmission.size());
    const std::size_t end = rest.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
    const std::string_view plugin = rest.substr(0, end);
    rest.remove_prefix(plugin.size());
    if (plugin.empty() || (!rest.empty() && rest[0] != '_' && rest[0] != '/')) return std::nullopt;
    if (rest.starts_with('_')) rest.remove_prefix(1);
    if (rest.starts_with('/')) rest.remove_prefix(1);
    ExportedFile file{std::string{path.substr(0, mark)}, std::string{rest}};
    if (plugin != "file" && !rest.empty()) file.path = std::string{plugin} + "/" + file.path;
    return file;
}

std::optional<ExportedFile> readFrom(std::string_view path) {
    if (auto file = readMoodlePath(path)) return file;
    if (auto name = readCanvasName(path)) return ExportedFile{name->owner, name->file};
    return std::nullopt;
}

struct Member {
    std::string path;
    bool mayBeWork = false;
};

bool mayBeWork(std::string_view file, const Exercise& exercise) {
    return !isLitter(file) && (isArchive(file) || partOf(file, exercise));
}

bool mayBeWork(const fs::directory_entry& entry, const Wanted& wanted) {
    std::error_code error;
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.') || name == "__MACOSX") return false;
    if (!entry.is_directory(error) || entry.is_symlink(error))
        return mayBeWork(name, wanted.exercise);
    return !fs::is_empty(entry.path(), error) && !isOut(entry.path(), wanted);
}

std::vector<Member> membersOf(const fs::path& folder, const Wanted& wanted) {
    std::error_code error;
    std::vector<Member> members;
    fs::directory_iterator entry{folder, error};
    for (; !error && entry != fs::directory_iterator{}; entry.increment(error))
        members.push_back({entry->path().filename().string(), mayBeWork(*entry, wanted)});
    return members;
}

std::vector<Member> membersOf(std::vector<std::string> paths, const Exercise& exercise) {
    std::vector<Member> members;
    for (std::string& path : paths) {
        const bool isWork = mayBeWork(path, exercise);
        members.push_back({std::move(path), isWork});
    }
    return members;
}

ClassExport exportOf(const std::vector<Member>& members) {
    std::set<std::string> owners;
    std::set<std::string> others;
    for (const Member& member : members) {
        if (const auto file = readExportedPath(member.path))
            owners.insert(file->owner);
        else if (member.mayBeWork)
            others.insert(member.path.substr(0, member.path.find('/')));
    }
    // A student can give a folder such a name; that does not make the class an export.
    if (owners.size() <= others.size()) return {};
    return {{owners.begin(), owners.end()}, {others.begin(), others.end()}, {}};
}

}  // namespace

std::optional<ExportedFile> readExportedPath(std::string_view path) {
    if (isLitter(path)) return std::nullopt;
    if (auto file = readFrom(path)) return file;
    const std::size_t slash = path.find('/');
    return slash == std::string_view::npos ? std::nullopt : readFrom(path.substr(slash + 1));
}

ClassExport readClassExport(const fs::path& exported, const Wanted& wanted) {
    std::error_code error;
    const fs::file_status status = fs::status(exported, error);
    if (error) return {};  // in a folder that may be listed, not searched
    if (fs::is_directory(status)) return exportOf(membersOf(exported, wanted));
    MemberList list = listArchive(exported);
    ClassExport found = exportOf(membersOf(std::move(list.paths), wanted.exercise));
    if (!found.owners.empty()) found.damage = std::move(list.damage);
    return found;
}

raytracer::InputError damagedDownload(const fs::path& exported, const std::string& damage) {
    return {exported.string(), 0,
            fmt::format("this class download is not whole ({}); download it again, then grade it",
                        damage)};
}

// Moodle's names contain no slash, so that no owner can be confused with one of the others.
std::string ownerOfOther(std::string_view other) {
    return std::string{other} + "/";
}

std::optional<std::string> pathInWork(std::string_view owner, std::string_view path) {
    if (owner.empty()) return std::string{path};
    auto file = readExportedPath(path);
    const bool isOther = !file && ownerOfOther(path.substr(0, path.find('/'))) == owner;
    if (isOther) return std::string{path};
    if (!file || file->owner != owner) return std::nullopt;
    return std::move(file->path);
}

}  // namespace ticker::intake
