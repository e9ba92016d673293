#ifndef TICKER_REPORT_PAGEPARTS_H
#define TICKER_REPORT_PAGEPARTS_H

#include <grader/exercise/Exercise.h>
#include <grader/result/Decision.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::report {

// Parts of the pages, as HTML. Text from students is escaped.

/// A word on a coloured background; `kind` is a word of result.json.
[[nodiscard]] std::string badge(std::string_view kind, std::string_view words);

/// A path for an attribute: unusual characters are percent-encoded.
[[nodiscard]] std::string address(std::string_view path);

/// A complete page. Its policy allows pictures inside it and below its folder, and this script
/// only.
[[nodiscard]] std::string page(std::string_view title, std::string_view css, std::string_view js,
                               std::string_view body);

/// The pictures of a result. A page embeds as many as fit, the small ones first. The others, and
/// pictures of a result that was read back without them, are files beside the page.
class Album {
public:
    /// @param folder  Path from the page to the result's folder: empty, or with a slash at its end.
    explicit Album(const SubmissionResult& result, std::string folder = {});

    /// The value of the attribute src; empty for a file that is not a result's picture.
    [[nodiscard]] std::string addressOf(const std::string& file) const;
    [[nodiscard]] bool has(const std::string& file) const { return pictures_.contains(file); }

private:
    std::string folder_;
    std::map<std::string, std::string> pictures_;  // addresses by file
};

/// One finding with its message, hint, pictures and measured values.
/// @param seen  HTML of the task's other plots and pictures.
[[nodiscard]] std::string findingCard(const Finding& finding, const Album& album,
                                      const std::string& seen);

/// Plots and pictures as figures; empty without any.
[[nodiscard]] std::string figures(const std::vector<ScatterPlot>& plots,
                                  const std::vector<Raster>& rasters, const Album& album);

/// Keys of a page that control its pictures.
enum class PictureKeys {
    all,
    blinkAndZoom  ///< the page uses the other keys itself, and lists its keys
};

/// Expected and submitted pictures; empty without any.
[[nodiscard]] std::string picturesSection(const SubmissionResult& result, const Album& album,
                                          PictureKeys keys = PictureKeys::all);

/// The compiler's messages, beside the student's lines; empty without messages.
[[nodiscard]] std::string diagnosticsSection(const SubmissionResult& result);

/// What a person said about lines of the student's code, each beside its line; empty where nothing
/// was said.
[[nodiscard]] std::string notesSection(const SubmissionResult& result,
                                       const std::vector<LineNote>& notes);

}  // namespace ticker::report

#endif
