#ifndef TICKER_INTAKE_LAYOUT_H
#define TICKER_INTAKE_LAYOUT_H

#include <grader/exercise/Exercise.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace ticker::intake {

/// What lies in a folder, by name.
struct Entries {
    std::vector<std::filesystem::path> folders;
    std::vector<std::filesystem::path> archives;
    std::set<std::string> parts;  ///< that lie in the folder itself
    bool isEmpty = true;
};

/// A submission, and the folder, archive or owner that it is named after.
struct Place {
    std::filesystem::path content;
    std::string namedAfter;
    std::string owner = {};  ///< see Located
    int depth = 0;           ///< of that folder, archive or owner
};

/// What lies below a folder.
struct Below {
    std::vector<Place> submissions;
    std::multiset<std::string> parts;  ///< of all of them, but for archives
    bool isSubmission = false;         ///< the folder itself is one
    bool isEmpty = true;
};

/// Whether the folders of a level, and the archives in it, are people, not groups of people.
[[nodiscard]] bool arePeople(const std::vector<Below>& children, const Entries& entries);

/// src/File.cpp and pictures/screenshot.png: one submission over two folders. They are taken
/// for one only where their names say so: ann/File.cpp and bob/screenshot.png are two people.
[[nodiscard]] bool isOneInPieces(const Below& below, const std::vector<Below>& children,
                                 const Entries& entries, const Exercise& exercise);

/// Somebody handed in the whole project, as the kit lays it out, perhaps with one more folder of
/// his own. Beside work in more places, or in the framework itself, these are two people's folders.
[[nodiscard]] bool isKit(const std::vector<Below>& children, const Entries& entries,
                         const Exercise& exercise);

}  // namespace ticker::intake

#endif
