#ifndef TICKER_SIMILAR_SIMILARPAGE_H
#define TICKER_SIMILAR_SIMILARPAGE_H

#include <grader/similar/Similar.h>

#include <string>
#include <vector>

namespace ticker::similar {

/// The comparison of one file of the exercise.
struct ComparedFile {
    std::string name;  ///< of the exercise's file
    std::vector<StudentFile> files;
    Comparison comparison;
    std::vector<std::string> leftOut = {};  ///< submissions whose file is too long to be compared
};

/// The text of similar.html, for staff: each pair with the two files beside each other.
[[nodiscard]] std::string similarPage(const std::vector<ComparedFile>& compared);

/// The pairs for programs, similar.json: [{"left", "right", "file", "percent"}].
[[nodiscard]] std::string similarJson(const std::vector<ComparedFile>& compared);

}  // namespace ticker::similar

#endif
