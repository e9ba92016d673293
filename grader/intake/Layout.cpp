#include <grader/base/Utf8.h>
#include <grader/intake/Layout.h>

#include <algorithm>
#include <cctype>

namespace ticker::intake {
namespace fs = std::filesystem;
namespace {

const std::string kPicture{kScreenshotPart};

// "Pictures" -> "picture", "tick1star" -> "tickstar"
std::string kindOf(const fs::path& folder) {
    std::string kind;
    for (const char c : lowerCase(folder.filename().string()))
        if (std::isalpha(static_cast<unsigned char>(c)) != 0) kind += c;
    if (kind.ends_with('s')) kind.pop_back();
    return kind;
}

bool isForCode(const fs::path& folder) {
    static const std::set<std::string> kKinds{"src",  "source",   "code",     "exercise",
                                              "tick", "tickstar", "solution", "work"};
    return kKinds.contains(kindOf(folder));
}

bool isForPictures(const fs::path& folder) {
    static const std::set<std::string> kKinds{"pic",        "picture", "image",  "img",
                                              "screenshot", "screen",  "output", "render"};
    return kKinds.contains(kindOf(folder));
}

/// Whether the folder is a whole project in the kit's layout, perhaps with one additional folder.
/// With work in more folders, or in the framework itself, the folders belong to two students.
bool isKit(const Level& level, const Exercise& exercise) {
    const Below* solved = nullptr;
    const Below* framework = nullptr;
    std::size_t others = level.entries.archives.size();
    bool othersHaveCode = others > 0;
    for (const Below& child : level.children) {
        if (child.folder.filename() == "exercise") {
            solved = &child;
        } else if (child.folder.filename() == "framework") {
            framework = &child;
        } else if (!child.submissions.empty()) {
            ++others;
            othersHaveCode = othersHaveCode || child.parts.count(kPicture) < child.parts.size();
        }
    }
    if (solved == nullptr || framework == nullptr || framework->isSubmission) return false;
    // Another folder may contain code only if exercise/ has every file: otherwise the other
    // folder's files, perhaps another student's, would be added to a part of the work.
    const bool isWhole = std::ranges::all_of(
        exercise.files(), [&](const std::string& file) { return solved->parts.contains(file); });
    return others == 0 || (others == 1 && (isWhole || !othersHaveCode));
}

/// src/File.cpp and pictures/screenshot.png: one submission in two folders. Folders count as one
/// submission only if their names say so: ann/File.cpp and bob/screenshot.png are two students.
bool isOneInPieces(const Level& level) {
    std::size_t code = 0;
    std::size_t pictures = 0;
    std::multiset<std::string> parts;
    for (const Below& child : level.children) {
        if (child.submissions.empty()) continue;
        const bool isPicture = child.parts == std::multiset<std::string>{kPicture};
        if (!(isPicture ? isForPictures(child.folder) : isForCode(child.folder))) return false;
        ++(isPicture ? pictures : code);
        parts.insert(child.parts.begin(), child.parts.end());
    }
    return level.entries.archives.empty() && code == 1 && pictures == 1 &&
           std::ranges::adjacent_find(parts) == parts.end();
}

/// Whether an unreadable folder below has the name of a submission's piece, such as src, and only
/// such pieces lie beside it: without it they are no whole submission.
bool lacksAPiece(const Level& level) {
    bool isLacking = false;
    for (const Below& child : level.children) {
        const bool isPiece = isForCode(child.folder) || isForPictures(child.folder);
        if (!isPiece && !child.submissions.empty()) return false;
        isLacking = isLacking || (isPiece && child.isUnreadable);
    }
    return isLacking && level.entries.archives.empty();
}

}  // namespace

bool isSubmission(const Level& level, const Exercise& exercise) {
    return !level.entries.parts.empty() || isKit(level, exercise) || isOneInPieces(level) ||
           lacksAPiece(level);
}

bool arePeople(const Level& level) {
    if (!level.entries.archives.empty()) return true;
    std::size_t one = 0;
    std::size_t more = 0;
    for (const Below& child : level.children) {
        if (child.isSubmission) return true;
        one += child.submissions.size() == 1 ? 1 : 0;
        more += child.submissions.size() > 1 ? 1 : 0;
    }
    return one >= 2 && one > more;
}

}  // namespace ticker::intake
