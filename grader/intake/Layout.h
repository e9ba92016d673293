#ifndef TICKER_INTAKE_LAYOUT_H
#define TICKER_INTAKE_LAYOUT_H

#include <grader/exercise/Exercise.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace ticker::intake {

/// Contents of a folder, by name.
struct Entries {
    std::vector<std::filesystem::path> folders;
    std::vector<std::filesystem::path> archives;
    std::set<std::string> parts;  ///< parts in the folder itself
    bool isEmpty = true;
    bool isUnreadable = false;  ///< some or all of its contents are unknown
};

/// A submission, and the folder, archive or owner that names it.
struct Place {
    std::filesystem::path content;
    std::string namedAfter;
    std::string owner = {};  ///< see Located
    int depth = 0;           ///< of that folder, archive or owner
};

/// What is below a folder.
struct Below {
    std::vector<Place> submissions;
    std::multiset<std::string> parts;  ///< parts of all of them, except archives
    bool isSubmission = false;         ///< the folder itself is one
    bool isEmpty = true;
    bool isUnreadable = false;  ///< the folder's contents are unknown
};

/// Whether the folders and archives of a level are students, rather than groups of students.
[[nodiscard]] bool arePeople(const std::vector<Below>& children, const Entries& entries);

/// src/File.cpp and pictures/screenshot.png: one submission in two folders. Folders count as one
/// submission only if their names say so: ann/File.cpp and bob/screenshot.png are two students.
[[nodiscard]] bool isOneInPieces(const Below& below, const std::vector<Below>& children,
                                 const Entries& entries, const Exercise& exercise);

/// Whether an unreadable folder below has the name of a submission's piece, such as src, and only
/// such pieces lie beside it: without it they are no whole submission.
[[nodiscard]] bool lacksAPiece(const std::vector<Below>& children, const Entries& entries);

/// Whether the folder is a whole project in the kit's layout, perhaps with one additional folder.
/// With work in more folders, or in the framework itself, the folders belong to two students.
[[nodiscard]] bool isKit(const std::vector<Below>& children, const Entries& entries,
                         const Exercise& exercise);

}  // namespace ticker::intake

#endif
