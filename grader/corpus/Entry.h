#ifndef TICKER_CORPUS_ENTRY_H
#define TICKER_CORPUS_ENTRY_H

#include <grader/corpus/MadeFile.h>
#include <grader/exercise/Exercise.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::corpus {

/// One replacement in a text.
struct Edit {
    std::string find;  ///< must occur exactly once in the text after the earlier edits
    std::string replace;
};

/// The expected result of one task.
struct Expectation {
    std::vector<std::string> states;  ///< as in result.json; any one of them is right
    /// Any one of these ids is right; an empty list: no finding. Without a value findings are not
    /// compared.
    std::optional<std::vector<std::string>> findings;
    bool needsReview = false;  ///< the task passes and asks for review

    [[nodiscard]] bool allows(std::string_view state) const;
    [[nodiscard]] bool passes() const { return states == std::vector<std::string>{"passed"}; }
    /// The first of the right findings, or "".
    [[nodiscard]] std::string finding() const;
    /// True if this id is among the right findings.
    [[nodiscard]] bool names(std::string_view finding) const;
    /// @param firstFinding  The most important finding's id; empty if the task has no finding.
    [[nodiscard]] bool isMet(std::string_view state, std::string_view firstFinding) const;
};

/// One submission of the corpus: its files and the expected result. grader/corpus/README.md
/// describes the format.
struct Entry {
    std::string collection;  ///< "samples", "accepted", "mistakes", "unseen", "hostile"; of another
                             ///< exercise than the default one "NAME/samples" and so on
    std::string group;       ///< the folders between collection and name: "T1", "T2/right", "cases"
    std::string name;        ///< of its folder, or of its file without ".json"
    std::string about;       ///< a short description
    std::string alone;       ///< reason not to combine it with other entries; may be empty
    std::string folderName;  ///< name under which it is handed in; usually `name`
    /// Folder of the files that are edited; empty if no file is edited.
    std::filesystem::path base;
    /// By file; an empty list: the base's file, unchanged.
    std::map<std::string, std::vector<Edit>> edits;
    std::vector<std::filesystem::path> files;  ///< files beside the entry
    std::vector<MadeFile> made;
    std::map<std::string, Expectation> tasks;  ///< by id: "T2.1"
    std::vector<std::string> verdicts;         ///< as in result.json; any one of them is right
    std::string path;                          ///< path of the entry, for messages

    /// The task whose folder contains the entry, or the only task with an expectation.
    [[nodiscard]] const std::string& task() const;
    /// Expectation of `task()`.
    [[nodiscard]] const Expectation& expected() const { return tasks.at(task()); }
    /// The edited or added file; the first by name if there are several.
    [[nodiscard]] std::string file() const;
};

/// Every entry of the named collections, sorted by group and name.
/// @param root  The project's folder, which contains grader/corpus, reference_solution, ...
/// @throws raytracer::InputError with the file, the line if known, and what was expected.
[[nodiscard]] std::vector<Entry> readEntries(const std::filesystem::path& root,
                                             const std::vector<std::string>& collections,
                                             const Exercise& exercise = defaultExercise());

/// The known mistakes and the accepted readings.
[[nodiscard]] std::vector<Entry> readCatalogue(const std::filesystem::path& root,
                                               const Exercise& exercise = defaultExercise());

/// Applies the edits to a text.
/// @param path  Name of the edits in messages.
/// @throws raytracer::InputError if an edit's `find` does not occur exactly once in the text.
[[nodiscard]] std::string applyEdits(std::string text, const std::vector<Edit>& edits,
                                     const std::string& path);

/// Texts of the edited files and of those beside the entry, by file name.
/// @throws raytracer::InputError if a file cannot be read or an edit does not apply.
[[nodiscard]] std::map<std::string, std::string> textsOf(const Entry& entry);

/// Writes the submission into `folder`, which must exist and be empty.
/// @param secret  Path of a file that the submission tries to read. Its texts contain the path
///                where the entry has the mark described in README.md. The file's contents must not
///                occur in any output.
/// @throws raytracer::Error if the submission cannot be written.
void writeSubmission(const Entry& entry, const std::filesystem::path& secret,
                     const std::filesystem::path& folder);

}  // namespace ticker::corpus

#endif
