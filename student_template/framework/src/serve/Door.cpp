#include <raytracer/serve/Door.h>

#include <cstddef>
#include <random>

namespace raytracer {
namespace {

constexpr std::size_t kTokenDigits = 32;
constexpr std::string_view kDigits = "0123456789abcdef";

bool isOwnOrigin(std::string_view origin, int port) {
    constexpr std::string_view kScheme = "http://";
    return origin.starts_with(kScheme) && namesThisServer(origin.substr(kScheme.size()), port);
}

}  // namespace

std::string freshToken() {
    std::random_device device;  // on all systems of today the kernel's generator
    std::uniform_int_distribution<std::size_t> digit{0, kDigits.size() - 1};
    std::string token;
    for (std::size_t i = 0; i < kTokenDigits; ++i)
        token += kDigits[digit(device)];
    return token;
}

bool isToken(std::string_view text) {
    return text.size() == kTokenDigits && text.find_first_not_of(kDigits) == std::string_view::npos;
}

bool namesThisServer(std::string_view host, int port) {
    // Appended, since GCC 12 warns of "literal" + string at -O3.
    std::string number{":"};
    number += std::to_string(port);
    if (!host.ends_with(number)) return false;
    host.remove_suffix(number.size());
    return host == "127.0.0.1" || host == "localhost";
}

bool isSameSecret(std::string_view one, std::string_view other) {
    if (one.size() != other.size()) return false;
    unsigned char difference = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        difference =
            static_cast<unsigned char>(difference | (static_cast<unsigned char>(one[i]) ^
                                                     static_cast<unsigned char>(other[i])));
    return difference == 0;
}

bool mayEnter(const RequestHead& head, std::string_view token, int port) {
    if (!namesThisServer(head.host, port)) return false;
    const std::string_view path{head.path};
    const std::string_view shown = path.substr(0, path.find('/', 1)).substr(path.empty() ? 0 : 1);
    if (!isSameSecret(shown, token)) return false;
    if (head.method == "GET" || head.method == "HEAD") return true;
    return head.method == "POST" && isSameSecret(head.proof, token) &&
           isOwnOrigin(head.origin, port);
}

}  // namespace raytracer
