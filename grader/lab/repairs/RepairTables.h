#ifndef TICKER_LAB_REPAIRS_REPAIRTABLES_H
#define TICKER_LAB_REPAIRS_REPAIRTABLES_H

#include <grader/lab/repairs/SeveralMistakes.h>

#include <cstddef>
#include <string>
#include <vector>

namespace ticker::lab {

/// What came of one wrong submission.
struct RepairRow {
    std::string collection;  ///< "mistakes", "unseen", "samples"; "tick1/mistakes" and so on
    std::string task;
    std::string name;
    bool isOneEdit = false;    ///< a mistake of the catalogue: one replacement of a few tokens
    bool isRepaired = false;   ///< at least one edit was proven to mend it
    bool isRightLine = false;  ///< the first one is in a line that the mistake's own edit changed
    bool wasCutOff = false;    ///< nothing was proven before the time was up
    double cpuMs = 0.0;        ///< CPU time in all; its parts follow
    double parseMs = 0.0;      ///< parsing the submission
    double compileMs = 0.0;    ///< compiling one program with all edits
    double askMs = 0.0;        ///< asking that program
    double proveMs = 0.0;      ///< compiling and asking edited submissions
    std::size_t tried = 0;     ///< number of sets of edits
    std::string edit;          ///< the first edit in words: "line 40: a + b -> a - b"
};

/// The name of a row's submission, unique over all exercises.
[[nodiscard]] std::string nameOf(const RepairRow& row);
/// A row as a line of the record, and back.
[[nodiscard]] std::string jsonOf(const RepairRow& row);
/// @throws raytracer::InputError if the text is not such a row.
[[nodiscard]] RepairRow rowOf(const std::string& json);

/// A row for people.
[[nodiscard]] std::string lineOf(const RepairRow& row);
/// All tables in Markdown: rates and cost for each group and task; mistakes of one edit without a
/// proven edit, or whose first proven edit is in another line; unseen submissions and samples
/// without a proven edit; those that are not counted as single mistakes, and why.
[[nodiscard]] std::string tablesOf(const std::vector<RepairRow>& rows,
                                   const SeveralMistakes& several);
/// A document with the tables between `<!-- repairs: tables -->` and `<!-- end -->`; without these
/// marks they come last.
[[nodiscard]] std::string withTables(const std::string& document, const std::string& tables);

}  // namespace ticker::lab

#endif
