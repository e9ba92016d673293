#include <grader/session/Access.h>

#include <grader/base/FileDescriptor.h>
#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <system_error>

namespace ticker::session {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFile = ".session";
constexpr std::size_t kTokenDigits = 32;

std::string freshToken() {
    std::array<unsigned char, kTokenDigits / 2> bytes{};
    if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw raytracer::Error("the system gives no random numbers");
    std::string token;
    for (const unsigned char byte : bytes)
        token += fmt::format("{:02x}", byte);
    return token;
}

bool isToken(const std::string& text) {
    return text.size() == kTokenDigits &&
           text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

// A file that other users can read or own is not secret.
bool isOurs(const fs::path& file) {
    struct stat status {};
    return lstat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
           status.st_uid == geteuid() && (status.st_mode & 077U) == 0;
}

}  // namespace

Access readAccess(const fs::path& out) {
    Access access{freshToken(), 0};
    if (!isOurs(out / kFile)) return access;
    const auto kept = nlohmann::json::parse(readIfThere(out / kFile).value_or(""), nullptr, false);
    if (!kept.is_object() || !kept.contains("token") || !kept["token"].is_string()) return access;
    const std::string token = kept["token"];
    if (!isToken(token)) return access;
    const bool hasPort = kept.contains("port") && kept["port"].is_number_unsigned();
    return {token, hasPort ? kept["port"].get<int>() : 0};
}

void writeAccess(const Access& access, const fs::path& out) {
    const PartFile part{out / kFile};
    const std::string text =
        nlohmann::json{{"token", access.token}, {"port", access.port}}.dump() + "\n";
    const FileDescriptor file{
        open(part.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600)};
    const bool written = file.isOpen() && write(file.get(), text.data(), text.size()) ==
                                              static_cast<ssize_t>(text.size());
    if (!written || part.rename())
        throw raytracer::InputError((out / kFile).string(), 0, "cannot be written");
}

bool namesThisServer(std::string_view host, int port) {
    return host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
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

}  // namespace ticker::session
