#include <grader/session/Access.h>

#include <grader/base/FileDescriptor.h>
#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>
#include <raytracer/serve/Door.h>

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace ticker::session {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFile = ".session";

// A file that other users can read or own is not secret.
bool isOurs(const fs::path& file) {
    struct stat status {};
    return lstat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) &&
           status.st_uid == geteuid() && (status.st_mode & 077U) == 0;
}

}  // namespace

Access readAccess(const fs::path& out) {
    Access access{raytracer::freshToken(), 0};
    if (!isOurs(out / kFile)) return access;
    const auto kept = nlohmann::json::parse(readIfThere(out / kFile).value_or(""), nullptr, false);
    if (!kept.is_object() || !kept.contains("token") || !kept["token"].is_string()) return access;
    const std::string token = kept["token"];
    if (!raytracer::isToken(token)) return access;
    const bool hasPort = kept.contains("port") && kept["port"].is_number_unsigned();
    return {token, hasPort ? kept["port"].get<int>() : 0};
}

void writeAccess(const Access& access, const fs::path& out) {
    const PartFile part{out / kFile};
    const std::string text =
        nlohmann::json{{"token", access.token}, {"port", access.port}}.dump() + "\n";
    const FileDescriptor file{
        open(part.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600)};
    if (file.isOpen()) errno = ENOSPC;  // what a write that ends early means
    const bool written = file.isOpen() && write(file.get(), text.data(), text.size()) ==
                                              static_cast<ssize_t>(text.size());
    const std::error_code why =
        written ? part.rename() : std::error_code{errno, std::generic_category()};
    if (why)
        throw raytracer::InputError(
            (out / kFile).string(), 0,
            "cannot be written: " + why.message() + "; make room or rights in this folder");
}

}  // namespace ticker::session
