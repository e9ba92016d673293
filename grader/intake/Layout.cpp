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

}  // namespace

bool arePeople(const std::vector<Below>& children, const Entries& entries) {
    const auto count = [&](auto&& holds) { return std::ranges::count_if(children, holds); };
    if (!entries.archives.empty()) return true;
    if (count([](const Below& child) { return child.isSubmission; }) > 0) return true;
    const auto one = count([](const Below& child) { return child.submissions.size() == 1; });
    const auto more = count([](const Below& child) { return child.submissions.size() > 1; });
    return one >= 2 && one > more;
}

bool isOneInPieces(const Below& below, const std::vector<Below>& children, const Entries& entries,
                   const Exercise& exercise) {
    std::size_t code = 0;
    std::size_t pictures = 0;
    for (std::size_t i = 0; i < children.size(); ++i) {
        if (children[i].submissions.empty()) continue;
        const bool isPicture = children[i].parts == std::multiset<std::string>{kPicture};
        const fs::path& folder = entries.folders[i];
        if (!(isPicture ? isForPictures(folder) : isForCode(folder))) return false;
        ++(isPicture ? pictures : code);
    }
    return entries.archives.empty() && code == 1 && pictures == 1 &&
           std::ranges::all_of(exercise.parts(), [&](const std::string& part) {
               return below.parts.count(part) <= 1;
           });
}

bool lacksAPiece(const std::vector<Below>& children, const Entries& entries) {
    bool isLacking = false;
    for (std::size_t i = 0; i < children.size(); ++i) {
        const bool isPiece = isForCode(entries.folders[i]) || isForPictures(entries.folders[i]);
        if (!isPiece && !children[i].submissions.empty()) return false;
        isLacking = isLacking || (isPiece && children[i].isUnreadable);
    }
    return isLacking && entries.archives.empty();
}

bool isKit(const std::vector<Below>& children, const Entries& entries, const Exercise& exercise) {
    const Below* solved = nullptr;
    const Below* framework = nullptr;
    std::size_t others = entries.archives.size();
    bool othersHaveCode = !entries.archives.empty();
    for (std::size_t i = 0; i < children.size(); ++i) {
        const fs::path name = entries.folders[i].filename();
        if (name == "exercise") {
            solved = &children[i];
        } else if (name == "framework") {
            framework = &children[i];
        } else if (!children[i].submissions.empty()) {
            ++others;
            othersHaveCode =
                othersHaveCode || children[i].parts.count(kPicture) < children[i].parts.size();
        }
    }
    if (solved == nullptr || framework == nullptr || framework->isSubmission) return false;
    // Another folder may contain code only if exercise/ has every file: otherwise the other
    // folder's files, perhaps another student's, would be added to a part of the work.
    const bool isWhole = std::ranges::all_of(
        exercise.files(), [&](const std::string& file) { return solved->parts.contains(file); });
    return others == 0 || (others == 1 && (isWhole || !othersHaveCode));
}

}  // namespace ticker::intake
