#ifndef TICKER_REPORT_PAGESOURCES_H
#define TICKER_REPORT_PAGESOURCES_H

#include <string>
#include <string_view>

namespace ticker::report {

// The files of grader/report/page, compiled into the program so that pages need no other files.
[[nodiscard]] std::string_view commonCss();
[[nodiscard]] std::string_view reportCss();
[[nodiscard]] std::string_view reportJs();
/// Part of `reportJs`: the class of pictures that lie over each other, and `drawRays`; bound to no
/// keys.
[[nodiscard]] std::string_view viewerJs();
[[nodiscard]] std::string_view classCss();
[[nodiscard]] std::string_view classJs();

/// "sha256-..." of one of these scripts, for a page's security policy.
[[nodiscard]] std::string scriptHash(std::string_view script);

}  // namespace ticker::report

#endif
