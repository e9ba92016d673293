#ifndef TICKER_CORPUS_ENTRY_H
#define TICKER_CORPUS_ENTRY_H

#include <grader/corpus/MadeFile.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::corpus {

/// One replacement in a text.
struct Edit {
    std::string find;  ///< must stand exactly once in the text, as earlier edits left it
    std::string replace;
};

/// What a grader must say about one task.
struct Expectation {
    std::vector<std::string> states;  ///< as in result.json; any one of them is right
    /// Any one of these ids is right; empty: no finding. Nothing: findings are not looked at.
    std::optional<std::vector<std::string>> findings;
    bool needsReview = false;  ///< it passes, and a person has to look

    [[nodiscard]] bool allows(std::string_view state) const;
    [[nodiscard]] bool passes() const { return states == std::vector<std::string>{"passed"}; }
    /// The first of the findings that are right, or "".
    [[nodiscard]] std::string finding() const;
    /// True where this id is among the findings that are right.
    [[nodiscard]] bool names(std::string_view finding) const;
    /// @param firstFinding  The most important finding's id; empty if the task has no finding.
    [[nodiscard]] bool isMet(std::string_view state, std::string_view firstFinding) const;
};

/// One submission of the corpus: how it is made, and what the grader must say about it.
/// grader/corpus/README.md has the format.
struct Entry {
    std::string collection;  ///< "samples", "accepted", "mistakes", "unseen" or "hostile"
    std::string group;       ///< the folders between collection and name: "T1", "T2/right", "cases"
    std::string name;        ///< of its folder, or of its file without ".json"
    std::string about;       ///< what it is, in a few words
    std::string folderName;  ///< under which it is handed in; mostly `name`
    std::filesystem::path
        base;  ///< folder of the files that are edited; empty if no file is edited
    std::map<std::string, std::vector<Edit>> edits;  ///< by file; none: the base's file as it is
    std::vector<std::filesystem::path> files;        ///< that lie beside the entry
    std::vector<MadeFile> made;
    std::map<std::string, Expectation> tasks;  ///< by id: "T2.1"
    std::vector<std::string> verdicts;         ///< as in result.json; any one of them is right
    std::string path;                          ///< where it was read, for messages

    /// The task whose folder it lies in, or the only one that it says something about.
    [[nodiscard]] const std::string& task() const;
    /// What is expected of `task()`.
    [[nodiscard]] const Expectation& expected() const { return tasks.at(task()); }
    /// The file that is edited or lies beside; the first by name where there are several.
    [[nodiscard]] std::string file() const;
};

/// Every entry of some collections, sorted by group and name.
/// @param root  The project's folder: it holds grader/corpus, reference_solution, ...
/// @throws raytracer::InputError naming file, line where known, and what was expected.
[[nodiscard]] std::vector<Entry> readEntries(const std::filesystem::path& root,
                                             const std::vector<std::string>& collections);

/// The known mistakes and the accepted readings.
[[nodiscard]] std::vector<Entry> readCatalogue(const std::filesystem::path& root);

/// A text with edits made in it.
/// @param path  Names the edits in messages.
/// @throws raytracer::InputError where an edit's `find` does not stand exactly once in the text.
[[nodiscard]] std::string applyEdits(std::string text, const std::vector<Edit>& edits,
                                     const std::string& path);

/// The texts by file name, of the files that are edited and of those beside the entry.
/// @throws raytracer::InputError where a file cannot be read or an edit does not fit.
[[nodiscard]] std::map<std::string, std::string> textsOf(const Entry& entry);

/// Writes the submission into `folder`, which must exist and be empty.
/// @param secret  Path of a file that the submission shall go for: its texts have it where the
/// entry
///                has the mark of README.md. Its contents must turn up in no output.
/// @throws raytracer::Error where it cannot be written.
void writeSubmission(const Entry& entry, const std::filesystem::path& secret,
                     const std::filesystem::path& folder);

}  // namespace ticker::corpus

#endif
