#include <grader/intake/ClassExport.h>
#include <grader/intake/Intake.h>
#include <grader/intake/Layout.h>
#include <grader/intake/SafeName.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <set>
#include <system_error>
#include <tuple>

namespace ticker::intake {
namespace fs = std::filesystem;
namespace {

constexpr int kDeepest = 8;

bool isHidden(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.starts_with('.') || name == "__MACOSX";
}

Entries entriesOf(const fs::path& folder, const Exercise& exercise) {
    Entries entries;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator{folder, error}) {
        if (isHidden(entry.path())) continue;
        entries.isEmpty = false;
        if (entry.is_directory(error) && !entry.is_symlink(error)) {
            entries.folders.push_back(entry.path());
        } else if (const auto part = partOf(entry.path().string(), exercise)) {
            entries.parts.insert(*part);
        } else if (isArchive(entry.path().filename().string()) && entry.is_regular_file(error)) {
            entries.archives.push_back(entry.path());
        }
    }
    std::ranges::sort(entries.folders);
    std::ranges::sort(entries.archives);
    return entries;
}

std::string withoutArchiveEnding(std::string name) {
    for (const char* ending : {".gz", ".tar", ".tgz", ".zip"}) {
        const std::string_view end{ending};
        if (name.size() > end.size() && name.ends_with(end)) name.resize(name.size() - end.size());
    }
    return name;
}

Place placeAt(const fs::path& path, int depth) {
    const std::string name = path.filename().string();
    return {path, isArchive(name) ? withoutArchiveEnding(name) : name, {}, depth};
}

std::vector<Place> placesInExport(const fs::path& exported, const Exercise& exercise) {
    const ClassExport found = readClassExport(exported, exercise);
    std::vector<Place> places;
    for (const std::string& owner : found.owners)
        places.push_back({exported, owner, owner});
    for (const std::string& other : found.others)
        places.push_back({exported, isArchive(other) ? withoutArchiveEnding(other) : other,
                          ownerOfOther(other), 1});
    return places;
}

// ann/tick/File.cpp beside bob/work/File.cpp: the names are ann and bob, not tick and work. Of
// ann/zoe/ and ann/yan/ neither may be called zoe or yan: the names are ann-zoe and ann-yan.
void nameAfter(const std::string& person, int depth, Below& child) {
    const bool isAlone = child.submissions.size() == 1;
    for (Place& place : child.submissions) {
        place.namedAfter = isAlone ? person : person + "-" + place.namedAfter;
        place.depth = isAlone ? depth : depth + 1;
    }
}

void add(Below& below, const Below& child) {
    below.submissions.insert(below.submissions.end(), child.submissions.begin(),
                             child.submissions.end());
    below.parts.insert(child.parts.begin(), child.parts.end());
}

Below look(const fs::path& folder, int depth, const Exercise& exercise) {
    const Entries entries = entriesOf(folder, exercise);
    std::vector<Below> children;
    if (depth < kDeepest)
        for (const fs::path& child : entries.folders)
            children.push_back(look(child, depth + 1, exercise));
    const bool people = arePeople(children, entries);
    for (std::size_t i = 0; people && i < children.size(); ++i)
        nameAfter(entries.folders[i].filename().string(), depth + 1, children[i]);

    Below below;
    below.isEmpty = entries.isEmpty;
    for (const Below& child : children)
        add(below, child);
    below.parts.insert(entries.parts.begin(), entries.parts.end());
    if (!entries.parts.empty() || isKit(children, entries, exercise) ||
        isOneInPieces(below, children, entries, exercise))
        return {{placeAt(folder, depth)}, below.parts, true, false};
    for (const fs::path& archive : entries.archives)
        below.submissions.push_back(placeAt(archive, depth + 1));
    for (std::size_t i = 0; people && i < children.size(); ++i)
        if (children[i].submissions.empty() && !children[i].isEmpty)
            below.submissions.push_back(placeAt(entries.folders[i], depth + 1));
    return below;
}

// All owners of the exports below folders that an unpacker made. If such a folder lies beside other
// submissions, it is one student's folder with made-up names inside.
std::vector<Place> placesInUnpacked(const fs::path& folder, const Exercise& exercise) {
    const Entries entries = entriesOf(folder, exercise);
    const bool allAreExports = entries.parts.empty() &&
                               std::ranges::all_of(entries.archives, [&](const fs::path& archive) {
                                   return !placesInExport(archive, exercise).empty();
                               });
    if (!allAreExports) return {};
    std::vector<Place> found;
    std::vector<Place> others;
    for (const fs::path& archive : entries.archives)
        others.push_back(placeAt(archive, 1));
    for (const fs::path& child : entries.folders) {
        const std::vector<Place> places = placesInExport(child, exercise);
        found.insert(found.end(), places.begin(), places.end());
        if (!places.empty()) continue;
        const Below below = look(child, 1, exercise);
        if (!below.submissions.empty()) return {};
        if (!below.isEmpty) others.push_back(placeAt(child, 1));
    }
    if (found.empty()) return {};
    found.insert(found.end(), others.begin(), others.end());
    return found;
}

std::vector<Place> placesIn(const fs::path& folder, const Exercise& exercise) {
    std::vector<Place> found = placesInExport(folder, exercise);
    if (found.empty()) found = placesInUnpacked(folder, exercise);
    if (found.empty()) found = look(folder, 0, exercise).submissions;
    return found;
}

// If two submissions want one name, the deeper one gets another, and so does a name that had to be
// changed: "zoe" is the folder zoe of the class, neither ann/zoe nor "-zoe".
std::vector<Located> named(const std::vector<Place>& places) {
    std::vector<std::tuple<int, bool, std::size_t>> order;
    for (std::size_t i = 0; i < places.size(); ++i)
        order.emplace_back(places[i].depth, safeName(places[i].namedAfter) != places[i].namedAfter,
                           i);
    std::ranges::sort(order);
    std::vector<Located> located(places.size());
    std::set<std::string> taken;
    for (const auto& [depth, isChanged, i] : order)
        located[i] = {uniqueName(safeName(places[i].namedAfter), taken), places[i].content,
                      places[i].owner};
    return located;
}

}  // namespace

std::vector<Located> findSubmissions(const fs::path& path, const Exercise& exercise) {
    std::error_code error;
    const fs::path whole = fs::canonical(path, error);
    if (error) throw raytracer::InputError(path.string(), 0, "cannot be read: " + error.message());
    std::vector<Place> found;
    if (fs::is_directory(whole)) {
        found = placesIn(whole, exercise);
        if (found.empty()) found = {placeAt(whole, 0)};
    } else if (fs::is_regular_file(whole) && isArchive(whole.filename().string())) {
        found = placesInExport(whole, exercise);
        if (found.empty()) found = {placeAt(whole, 0)};
    } else {
        throw raytracer::InputError(path.string(), 0, "neither a folder nor a zip or tar archive");
    }
    std::ranges::sort(found, {},
                      [](const Place& place) { return std::tie(place.content, place.owner); });
    return named(found);
}

}  // namespace ticker::intake
