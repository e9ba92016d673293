#ifndef TICKER_SESSION_ACCESS_H
#define TICKER_SESSION_ACCESS_H

#include <filesystem>
#include <string>
#include <string_view>

namespace ticker::session {

/// What a page has to know to be let in. Kept in OUT, readable by its owner alone, so that a page
/// that is open goes on working when the session is started again.
struct Access {
    std::string token;  ///< 32 hexadecimal digits from the system's generator
    int port = 0;       ///< of the last session; 0: none yet
};

/// Reads OUT/.session, or makes a fresh access.
[[nodiscard]] Access readAccess(const std::filesystem::path& out);

/// @throws raytracer::InputError where it cannot be written.
void writeAccess(const Access& access, const std::filesystem::path& out);

/// True where the header Host, or Origin without its "http://", names this machine and port. What
/// another site's page sends, and a name that somebody points here, does not.
[[nodiscard]] bool namesThisServer(std::string_view host, int port);

/// True for equal texts; takes the same time wherever they differ.
[[nodiscard]] bool isSameSecret(std::string_view one, std::string_view other);

}  // namespace ticker::session

#endif
