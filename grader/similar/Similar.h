#ifndef TICKER_SIMILAR_SIMILAR_H
#define TICKER_SIMILAR_SIMILAR_H

#include <grader/sandbox/Sandbox.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::similar {

/// The percentage of shared code from which a pair is listed. docs/similarity.md says how many
/// pairs of the corpus it lists by mistake, and how many copies it misses.
inline constexpr int kLeastPercent = 40;

/// A file with less code of its own, in characters without spaces and comments, is not compared:
/// percentages of a few lines say nothing.
inline constexpr std::size_t kLeastCode = 350;

/// Pairs whose passages are looked for, and that the page shows: a longer list is no help.
inline constexpr std::size_t kMostPairs = 200;

/// One student's file.
struct StudentFile {
    std::string submission;
    std::string text;  ///< any bytes
};

/// Lines of a file, counted from 1; both ends belong to it.
struct LineRange {
    int first = 0;
    int last = 0;
    bool operator==(const LineRange&) const = default;
};

/// The same code in two files, apart from names, numbers, comments and layout.
struct Passage {
    LineRange left;
    LineRange right;
    bool operator==(const Passage&) const = default;
};

/// Two files that share code of their own.
struct SimilarPair {
    std::size_t left = 0;  ///< index of the file
    std::size_t right = 0;
    int percent = 0;  ///< of their own code, the mean of both
    std::vector<Passage> passages;
};

/// A comparison of all files with each other.
struct Comparison {
    std::vector<SimilarPair> pairs;              ///< the most similar first
    std::vector<std::vector<LineRange>> common;  ///< of each file: lines that are no own code
    std::size_t compared = 0;                    ///< files that have enough code of their own
};

/// The program that finds the same code, of Debian's package similarity-tester; empty if it is not
/// installed.
[[nodiscard]] std::filesystem::path findMatcher();

/// How much code the files of a class share with each other, without the passages. Runs in the
/// sandbox.
/// @param known  Texts whose code does not count: the template and the reference.
/// @throws raytracer::InputError if the matcher is not installed; raytracer::Error if it fails.
[[nodiscard]] Comparison comparePercentages(const std::vector<StudentFile>& files,
                                            const std::vector<std::string>& known,
                                            const sandbox::Sandbox& sandbox,
                                            int leastPercent = kLeastPercent);

/// The same with the passages of the first kMostPairs pairs.
[[nodiscard]] Comparison compareFiles(const std::vector<StudentFile>& files,
                                      const std::vector<std::string>& known,
                                      const sandbox::Sandbox& sandbox,
                                      int leastPercent = kLeastPercent);

}  // namespace ticker::similar

#endif
