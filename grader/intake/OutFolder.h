#ifndef TICKER_INTAKE_OUTFOLDER_H
#define TICKER_INTAKE_OUTFOLDER_H

#include <grader/exercise/Exercise.h>

#include <filesystem>

namespace ticker::intake {

/// What the search for submissions looks for, and what it leaves out.
struct Wanted {
    const Exercise& exercise;          ///< whose files are looked for
    const std::filesystem::path& out;  ///< a folder of results; empty: none is known
};

/// True if ticker keeps the results of a class in the folder.
[[nodiscard]] bool holdsResults(const std::filesystem::path& folder);

/// True for a folder of results, `wanted.out` or another, that lies in a class: what it holds was
/// copied from submissions. A folder with a file of the exercise in it is a submission.
[[nodiscard]] bool isOut(const std::filesystem::path& folder, const Wanted& wanted);

}  // namespace ticker::intake

#endif
