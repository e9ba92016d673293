#ifndef RAYTRACER_SERVE_DOOR_H
#define RAYTRACER_SERVE_DOOR_H

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace raytracer {

/// 32 random hexadecimal digits from the system's generator.
[[nodiscard]] std::string freshToken();

/// True if a text has the form of a token from `freshToken`.
[[nodiscard]] bool isToken(std::string_view text);

/// True if the header Host, or Origin without its "http://", names this machine and port. False for
/// another site's page, and for another host name that resolves to this machine.
[[nodiscard]] bool namesThisServer(std::string_view host, int port);

/// True for equal texts; takes the same time wherever they differ.
[[nodiscard]] bool isSameSecret(std::string_view one, std::string_view other);

/// The parts of a request that decide whether a server on 127.0.0.1 answers it.
struct RequestHead {
    std::string method;
    std::string path;    ///< "/<token>/..."
    std::string host;    ///< header Host
    std::string origin;  ///< header Origin
    std::string proof;   ///< the page's own header, which holds the token
};

/// True if a server on 127.0.0.1 may answer the request. Every request must name this server and
/// carry the token in its path. A POST must also come from this server's page, and repeat the token
/// in a header that no other site's page can send.
[[nodiscard]] bool mayEnter(const RequestHead& head, std::string_view token, int port);

/// Headers of every answer: no caching, no guess of the content's type, no Referer, no use by pages
/// of other sites.
inline constexpr std::array<std::pair<const char*, const char*>, 4> kAnswerHeaders{
    {{"Cache-Control", "no-store"},
     {"Referrer-Policy", "no-referrer"},
     {"X-Content-Type-Options", "nosniff"},
     {"Cross-Origin-Resource-Policy", "same-origin"}}};

/// The security policy of a page: its own script and style, its own pictures and requests; nothing
/// else, and no frames.
inline constexpr const char* kPagePolicy =
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' "
    "data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

}  // namespace raytracer

#endif
