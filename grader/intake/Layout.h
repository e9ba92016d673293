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

/// What is in and below a folder.
struct Below {
    std::filesystem::path folder;
    std::vector<Place> submissions;
    std::multiset<std::string> parts;  ///< parts of all of them, except archives
    bool isSubmission = false;         ///< the folder itself is one
    bool isEmpty = true;
    bool isUnreadable = false;  ///< the folder's contents are unknown
};

/// A folder before it is decided what it is: its own contents, and what is below its folders.
struct Level {
    Entries entries;
    std::vector<Below> children;
};

/// Whether the folder itself is a submission: it has a part in it, or the kit's layout, or its
/// folders are the pieces of one.
[[nodiscard]] bool isSubmission(const Level& level, const Exercise& exercise);

/// Whether the folders and archives of a level are students, rather than groups of students.
[[nodiscard]] bool arePeople(const Level& level);

}  // namespace ticker::intake

#endif
