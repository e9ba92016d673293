#ifndef TICKER_LAB_SIMILAR_EVALUATE_H
#define TICKER_LAB_SIMILAR_EVALUATE_H

#include <grader/lab/similar/Disguise.h>
#include <grader/similar/Similar.h>

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace ticker::similar {

/// How many of some pairs were listed.
struct Listed {
    std::size_t listed = 0;
    std::size_t all = 0;
};

/// How many pairs of known origin are listed at one least percentage.
struct Row {
    std::string file;
    int leastPercent = 0;
    Listed independent;                            ///< pairs by different authors
    std::array<Listed, kDisguises.size()> copies;  ///< an original and its copy, by disguise
};

/// The evaluation's input for one file of the exercise.
struct Originals {
    std::string file;
    std::vector<StudentFile> files;
    std::vector<std::string> known;  ///< the template and the reference
    std::set<std::string> names;     ///< of the kit: a copy keeps them
};

/// The copy of a file that `evaluate` compares with it.
/// @param index  Of the file in `originals.files`.
[[nodiscard]] std::string copyOf(const Originals& originals, std::size_t index, Disguise disguise);

/// Makes copies of each file by every disguise and compares all of them.
[[nodiscard]] std::vector<Row> evaluate(const Originals& originals,
                                        const sandbox::Sandbox& sandbox);

/// The rows as a Markdown table with precision and recall.
[[nodiscard]] std::string tableOf(const std::vector<Row>& rows);

}  // namespace ticker::similar

#endif
