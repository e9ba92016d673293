#ifndef TICKER_SESSION_PAGESOURCES_H
#define TICKER_SESSION_PAGESOURCES_H

#include <string_view>

namespace ticker::session {

// The files of grader/session/page, carried in the program. The style sheet begins with those of
// the report's pages, whose parts the session shows.
[[nodiscard]] std::string_view pageHtml();
[[nodiscard]] std::string_view pageCss();
[[nodiscard]] std::string_view pageJs();  ///< begins with the viewer of the report's pages

}  // namespace ticker::session

#endif
