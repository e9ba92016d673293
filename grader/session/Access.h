#ifndef TICKER_SESSION_ACCESS_H
#define TICKER_SESSION_ACCESS_H

#include <filesystem>
#include <string>

namespace ticker::session {

/// Token and port of the session's page. They are stored in OUT, readable by its owner only, so
/// that an open page works again after the session is restarted.
struct Access {
    std::string token;  ///< 32 hexadecimal digits from the system's generator
    int port = 0;       ///< port of the last session; 0 before the first one
};

/// Reads OUT/.session, or creates fresh access data.
[[nodiscard]] Access readAccess(const std::filesystem::path& out);

/// @throws raytracer::InputError if it cannot be written.
void writeAccess(const Access& access, const std::filesystem::path& out);

}  // namespace ticker::session

#endif
