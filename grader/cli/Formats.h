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

/// The formats to write, and their options.
struct FormatOptions {
    std::vector<std::string> names;
    std::string worksheet;           ///< moodle's, or canvas's gradebook
    std::string assignment;          ///< canvas: its column in the gradebook
    std::string download;            ///< canvas: the zip of the submissions; empty: no comments
    std::vector<std::string> scale;  ///< moodle: words for "not awarded" and "awarded"
    /// moodle, canvas: leave out marks that are only the tool's proposal, and those whose decision
    /// is about an earlier hand-in
    bool decidedOnly = false;
    std::string studentView;  ///< empty: the kit's own
};

/// Adds the formats' options to a verb: --worksheet, --assignment, --download,
/// --scale, --decided-only, --student-view.
void addFormatOptions(CLI::App& verb, FormatOptions& options);

/// The formats of `writeFormats`: "autolab", "classroom", ...
[[nodiscard]] std::vector<std::string> formatNames();

/// Names of all files that `writeFormats` may write into a submission's folder, but report.html.
[[nodiscard]] std::vector<std::string> submissionFiles();

/// Writes one file for each submission, such as `OUT/<submission>/gradescope.json`, or one file for
/// the class in OUT; prints warnings on stderr, also about decisions on an earlier hand-in.
/// Students get the ticker's decision if there is one; the staff's files of the class contain the
/// tool's verdicts.
/// @return  The written files, in order. A format without a value for "could not be graded" writes
///          nothing for such a result, and removes the file of an earlier run.
/// @throws raytracer::InputError if a file cannot be read or written.
std::vector<std::filesystem::path> writeFormats(const std::filesystem::path& out,
                                                const std::vector<store::ClassEntry>& entries,
                                                const FormatOptions& options);

}  // namespace ticker::cli

#endif
