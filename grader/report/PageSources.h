#ifndef TICKER_REPORT_PAGESOURCES_H
#define TICKER_REPORT_PAGESOURCES_H

#include <string_view>

namespace ticker::report {

// The files of grader/report/page, carried in the program so that pages need nothing beside them.
[[nodiscard]] std::string_view commonCss();
[[nodiscard]] std::string_view reportCss();
[[nodiscard]] std::string_view reportJs();
[[nodiscard]] std::string_view classCss();
[[nodiscard]] std::string_view classJs();

}  // namespace ticker::report

#endif
