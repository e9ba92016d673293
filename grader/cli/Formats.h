#ifndef TICKER_CLI_FORMATS_H
#define TICKER_CLI_FORMATS_H

#include <grader/store/ClassFolder.h>

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ticker::cli {

/// Which formats to write, and what some of them need.
struct FormatOptions {
    std::vector<std::string> names;
    std::string worksheet;           ///< moodle's
    std::vector<std::string> scale;  ///< moodle's words for "not awarded" and "awarded"
    bool decidedOnly = false;        ///< moodle: no mark that is only the tool's proposal
    std::string studentView;         ///< empty: the kit's own
};

/// Adds what formats need to a verb: --worksheet, --scale, --decided-only, --student-view.
void addFormatOptions(CLI::App& verb, FormatOptions& options);

/// "autolab", "classroom", ...: what `writeFormats` knows.
[[nodiscard]] std::vector<std::string> formatNames();

/// Writes `OUT/<submission>/gradescope.json` and the like, one for each submission, or one file for
/// the class in OUT; says on stderr what somebody has to know. Where a person has decided, students
/// get that decision; staff's files of the class hold what the tool says.
/// @return What was written, in order. A format without a word for "could not be graded" writes
///         nothing for such a result, and removes what an earlier run wrote.
/// @throws raytracer::InputError where something cannot be read or written.
std::vector<std::filesystem::path> writeFormats(const std::filesystem::path& out,
                                                const std::vector<store::ClassEntry>& entries,
                                                const FormatOptions& options);

}  // namespace ticker::cli

#endif
