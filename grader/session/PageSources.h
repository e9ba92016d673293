#ifndef TICKER_SESSION_PAGESOURCES_H
#define TICKER_SESSION_PAGESOURCES_H

#include <functional>
#include <map>
#include <string>

namespace ticker::session {

/// The files of grader/session/page by name, carried in the program. session.css begins with the
/// styles of the report's pages, whose parts the session shows; viewer.js is their viewer.
[[nodiscard]] const std::map<std::string, std::string, std::less<>>& pageFiles();

}  // namespace ticker::session

#endif
