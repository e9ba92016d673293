#ifndef TICKER_REPORT_PAGEPARTS_H
#define TICKER_REPORT_PAGEPARTS_H

#include <grader/exercise/Exercise.h>
#include <grader/result/SubmissionResult.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::report {

// Parts of the pages, as HTML. What came from a student is escaped in them.

/// A word on a coloured ground; `kind` is one of the words of result.json.
[[nodiscard]] std::string badge(std::string_view kind, std::string_view words);

/// A path of our own naming, for an attribute: everything unusual percent-encoded.
[[nodiscard]] std::string address(std::string_view path);

/// A page from its doctype to its end. It may load nothing but pictures in itself and below its
/// folder, and run no script but this one.
[[nodiscard]] std::string page(std::string_view title, std::string_view css, std::string_view js,
                               std::string_view body);

/// The pictures of a result. A page carries as many as fit into it, the small ones first; the rest,
/// and those of a result that was read back without them, lie beside the page.
class Album {
public:
    /// @param folder  Where the result lies, as seen from the page: empty, or with a slash at its
    /// end.
    explicit Album(const SubmissionResult& result, std::string folder = {});

    /// For the attribute src; empty for what is no file of ours.
    [[nodiscard]] std::string addressOf(const std::string& file) const;
    [[nodiscard]] bool has(const std::string& file) const { return pictures_.contains(file); }

private:
    std::string folder_;
    std::map<std::string, std::string> pictures_;  // addresses by file
};

/// One finding with its message, hint, pictures and measured values.
/// @param seen  HTML of what else was seen of its task.
[[nodiscard]] std::string findingCard(const Finding& finding, const Album& album,
                                      const std::string& seen);

/// Plots and pictures of what was seen, as figures; empty where there are none.
[[nodiscard]] std::string figures(const std::vector<ScatterPlot>& plots,
                                  const std::vector<Raster>& rasters, const Album& album);

/// The keys of a page that act on its pictures.
enum class PictureKeys {
    all,
    blinkAndZoom  ///< others mean something else on this page, which tells its keys itself
};

/// Expected and submitted pictures; empty where there are none.
[[nodiscard]] std::string picturesSection(const SubmissionResult& result, const Album& album,
                                          PictureKeys keys = PictureKeys::all,
                                          const Exercise& exercise = theExercise());

/// What the compiler said, beside the student's lines; empty where it said nothing.
[[nodiscard]] std::string diagnosticsSection(const SubmissionResult& result);

}  // namespace ticker::report

#endif
