#include <grader/intake/ClassExport.h>
#include <grader/intake/Intake.h>
#include <grader/intake/Layout.h>
#include <grader/intake/SafeName.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

namespace ticker::intake {
namespace fs = std::filesystem;
namespace {

constexpr int kDeepest = 8;

// "lost+found" belongs to the disk, and only root can read it.
bool isHidden(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.starts_with('.') || name == "__MACOSX" || name == "lost+found";
}

void add(const fs::directory_entry& entry, const Wanted& wanted, Entries& entries) {
    std::error_code error;
    const bool isFolder = entry.is_directory(error) && !entry.is_symlink(error);
    if (isHidden(entry.path()) || (isFolder && isOut(entry.path(), wanted))) return;
    entries.isEmpty = false;
    if (isFolder) {
        entries.folders.push_back(entry.path());
    } else if (const auto part = partOf(entry.path().string(), wanted.exercise)) {
        entries.parts.insert(*part);
    } else if (isArchive(entry.path().filename().string()) && entry.is_regular_file(error)) {
        entries.archives.push_back(entry.path());
    }
}

Entries entriesOf(const fs::path& folder, const Wanted& wanted) {
    Entries entries;
    std::error_code error;
    fs::directory_iterator entry{folder, error};
    for (; !error && entry != fs::directory_iterator{}; entry.increment(error))
        add(*entry, wanted, entries);
    entries.isUnreadable = static_cast<bool>(error);
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

std::vector<Place> placesOf(const ClassExport& found, const fs::path& exported) {
    std::vector<Place> places;
    for (const std::string& owner : found.owners)
        places.push_back({exported, owner, owner});
    for (const std::string& other : found.others)
        places.push_back({exported, isArchive(other) ? withoutArchiveEnding(other) : other,
                          ownerOfOther(other), 1});
    return places;
}

std::vector<Place> placesInExport(const fs::path& folder, const Wanted& wanted) {
    return placesOf(readClassExport(folder, wanted), folder);
}

// It is unknown whose work a truncated download lacks, so that nothing of it is graded.
std::vector<Place> placesInDownload(const fs::path& zip, const Wanted& wanted) {
    const ClassExport found = readClassExport(zip, wanted);
    if (!found.damage.empty()) throw damagedDownload(zip, found.damage);
    return placesOf(found, zip);
}

// An archive that cannot be read counts as a submission; reading it later reports the error.
bool isDownload(const fs::path& zip, const Wanted& wanted) {
    try {
        return !readClassExport(zip, wanted).owners.empty();
    } catch (const raytracer::InputError&) {
        return false;
    }
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

// The submissions in a folder of several. Beside a student's folder, another one with contents is a
// student's, too, even if nothing in it has a right name.
std::vector<Place> placesBelow(Level level, int depth) {
    const bool people = arePeople(level);
    std::vector<Place> places;
    for (const fs::path& archive : level.entries.archives)
        places.push_back(placeAt(archive, depth + 1));
    for (Below& child : level.children) {
        if (child.submissions.empty() && (child.isUnreadable || (people && !child.isEmpty)))
            places.push_back(placeAt(child.folder, depth + 1));
        if (people) nameAfter(child.folder.filename().string(), depth + 1, child);
        std::ranges::move(child.submissions, std::back_inserter(places));
    }
    return places;
}

Below look(const fs::path& folder, int depth, const Wanted& wanted) {
    Level level{entriesOf(folder, wanted), {}};
    if (depth < kDeepest)
        for (const fs::path& child : level.entries.folders)
            level.children.push_back(look(child, depth + 1, wanted));

    Below below;
    below.folder = folder;
    below.isUnreadable = level.entries.isUnreadable;
    below.isEmpty = level.entries.isEmpty && !below.isUnreadable;
    below.parts.insert(level.entries.parts.begin(), level.entries.parts.end());
    for (const Below& child : level.children)
        below.parts.insert(child.parts.begin(), child.parts.end());
    below.isSubmission = isSubmission(level, wanted.exercise);
    below.submissions = below.isSubmission ? std::vector{placeAt(folder, depth)}
                                           : placesBelow(std::move(level), depth);
    return below;
}

// All owners of the exports below folders that an unpacker made. If such a folder lies beside other
// submissions, it is one student's folder with made-up names inside.
std::vector<Place> placesInUnpacked(const fs::path& folder, const Wanted& wanted) {
    const Entries entries = entriesOf(folder, wanted);
    const bool allAreExports = entries.parts.empty() &&
                               std::ranges::all_of(entries.archives, [&](const fs::path& archive) {
                                   return isDownload(archive, wanted);
                               });
    if (!allAreExports) return {};
    std::vector<Place> found;
    std::vector<Place> others;
    for (const fs::path& archive : entries.archives)
        others.push_back(placeAt(archive, 1));
    for (const fs::path& child : entries.folders) {
        const std::vector<Place> places = placesInExport(child, wanted);
        found.insert(found.end(), places.begin(), places.end());
        if (!places.empty()) continue;
        const Below below = look(child, 1, wanted);
        if (!below.submissions.empty()) return {};
        if (!below.isEmpty) others.push_back(placeAt(child, 1));
    }
    if (found.empty()) return {};
    found.insert(found.end(), others.begin(), others.end());
    return found;
}

std::vector<Place> placesIn(const fs::path& folder, const Wanted& wanted) {
    std::error_code error;
    const fs::directory_iterator first{folder, error};
    if (error) throw unreadable(folder, error.value());
    std::vector<Place> found = placesInExport(folder, wanted);
    if (found.empty()) found = placesInUnpacked(folder, wanted);
    if (found.empty()) found = look(folder, 0, wanted).submissions;
    return found;
}

// If two submissions want one name, the deeper one gets another, and so does a name that had to be
// changed: "zoe" is the folder zoe of the class, neither ann/zoe nor "-zoe".
std::vector<Located> named(const std::vector<Place>& places, const fs::path& out) {
    std::vector<std::tuple<int, bool, std::size_t>> order;
    for (std::size_t i = 0; i < places.size(); ++i)
        order.emplace_back(places[i].depth, safeName(places[i].namedAfter) != places[i].namedAfter,
                           i);
    std::ranges::sort(order);
    std::vector<Located> located(places.size());
    std::set<std::string> taken;
    for (const auto& [depth, isChanged, i] : order)
        located[i] = {uniqueName(safeName(places[i].namedAfter), taken), places[i].content,
                      places[i].owner, out};
    return located;
}

}  // namespace

std::vector<Located> findSubmissions(const fs::path& path, const Exercise& exercise,
                                     const fs::path& out) {
    std::error_code error;
    const fs::path whole = fs::canonical(path, error);
    if (error) throw raytracer::InputError(path.string(), 0, "cannot be read: " + error.message());
    const fs::file_status status = fs::status(whole, error);
    if (error) throw unreadable(path, error.value());
    const Wanted wanted{exercise, out};
    std::vector<Place> found;
    if (fs::is_directory(status)) {
        found = placesIn(whole, wanted);
    } else if (fs::is_regular_file(status) && isArchive(whole.filename().string())) {
        found = placesInDownload(whole, wanted);
    } else {
        throw raytracer::InputError(path.string(), 0, "neither a folder nor a zip or tar archive");
    }
    if (found.empty()) found = {placeAt(whole, 0)};
    std::ranges::sort(found, {},
                      [](const Place& place) { return std::tie(place.content, place.owner); });
    return named(found, out);
}

}  // namespace ticker::intake
