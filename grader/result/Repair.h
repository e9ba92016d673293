#ifndef TICKER_RESULT_REPAIR_H
#define TICKER_RESULT_REPAIR_H

#include <string>
#include <vector>

namespace ticker {

/// One place of an edit, in whole lines.
struct RepairEdit {
    int line = 0;      ///< the first of the old lines; 1 for the file's first
    std::string from;  ///< untrusted: the student's text
    std::string to;    ///< empty: the lines are left out
};

/// An edit of a submission that was proven to mend a failed task.
struct Repair {
    std::string task;
    std::string finding;  ///< the failing one that it mends
    std::string file;
    std::vector<RepairEdit> edits;  ///< at least one; several if all are needed together
    bool proven = false;            ///< judged in full, with one result under three seeds
    /// The finding that is left with this edit; empty: the task passes.
    std::string next;
};

}  // namespace ticker

#endif
