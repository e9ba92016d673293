#ifndef TICKER_SESSION_SESSIONSOURCES_H
#define TICKER_SESSION_SESSIONSOURCES_H

#include <functional>
#include <map>
#include <string>

namespace ticker::session {

/// The files of grader/session/page by name, compiled into the program. session.css begins with the
/// style sheets of the reports, and viewer.js is the reports' script, since the session shows parts
/// of reports.
[[nodiscard]] const std::map<std::string, std::string, std::less<>>& pageFiles();

}  // namespace ticker::session

#endif
