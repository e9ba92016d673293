#ifndef TICKER_SESSION_ACCESS_H
#define TICKER_SESSION_ACCESS_H

#include <filesystem>
#include <string>
#include <string_view>

namespace ticker::session {

/// Access data of the session's page. Stored in OUT, readable by its owner only, so that an open
/// page keeps working when the session is restarted.
struct Access {
    std::string token;  ///< 32 hexadecimal digits from the system's generator
    int port = 0;       ///< port of the last session; 0 before the first one
};

/// Reads OUT/.session, or creates fresh access data.
[[nodiscard]] Access readAccess(const std::filesystem::path& out);

/// @throws raytracer::InputError if it cannot be written.
void writeAccess(const Access& access, const std::filesystem::path& out);

/// True if the header Host, or Origin without its "http://", names this machine and port. Requests
/// of other sites' pages, and host names that point to this machine, do not.
[[nodiscard]] bool namesThisServer(std::string_view host, int port);

/// True for equal texts; the time taken does not depend on where they differ.
[[nodiscard]] bool isSameSecret(std::string_view one, std::string_view other);

}  // namespace ticker::session

#endif
