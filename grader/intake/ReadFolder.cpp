#include <grader/intake/Contents.h>
#include <grader/intake/Utf8.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <system_error>

namespace ticker::intake {
namespace {

struct CloseFolder {
    void operator()(DIR* folder) const { closedir(folder); }
};
using Folder = std::unique_ptr<DIR, CloseFolder>;

class OpenFile {
public:
    explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
    ~OpenFile() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    [[nodiscard]] int get() const { return descriptor_; }

private:
    int descriptor_;
};

// At most limit + 1 bytes, so that a file that grows while it is read is noticed.
std::optional<std::string> readUpTo(int descriptor, std::uint64_t limit) {
    std::string bytes;
    std::string buffer(64U << 10U, '\0');
    while (bytes.size() <= limit) {
        const ssize_t size = read(descriptor, buffer.data(), buffer.size());
        if (size < 0) return std::nullopt;
        if (size == 0) break;
        bytes.append(buffer, 0, static_cast<std::size_t>(size));
    }
    return bytes;
}

/// Walks through a folder by descriptors: nobody can put a link in the way meanwhile.
class FolderReader {
public:
    explicit FolderReader(const IntakeLimits& limits) : limits_(limits) {}

    void read(int descriptor, const std::string& prefix, int depth) {
        const Folder folder{fdopendir(descriptor)};
        if (!folder) {
            close(descriptor);
            return;
        }
        std::vector<std::string> names;
        // NOLINTNEXTLINE(concurrency-mt-unsafe): each stream is read by one thread
        while (const dirent* entry = readdir(folder.get())) {
            const std::string name{entry->d_name};
            if (name != "." && name != "..") names.push_back(name);
            if (++members_ > limits_.members) return refuseCount();
        }
        std::ranges::sort(names);
        for (const std::string& name : names)
            visit(dirfd(folder.get()), name, prefix + name, depth);
    }

    [[nodiscard]] Contents take() { return std::move(contents_); }

private:
    void refuseCount() {
        contents_.refusals.push_back(
            refusal("intake.too-large", fmt::format("More than {} files.", limits_.members),
                    "Hand in the two or three files that the exercise names."));
    }

    void visit(int parent, const std::string& name, const std::string& path, int depth) {
        struct stat status {};
        const bool known = fstatat(parent, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
        if (known && S_ISDIR(status.st_mode) && !isLitter(path) && depth < limits_.depth) {
            const int child =
                openat(parent, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
            if (child >= 0) return read(child, path + "/", depth + 1);
        }
        const std::optional<Part> part = isLitter(path) ? std::nullopt : partOf(path);
        if (part && !(known && S_ISDIR(status.st_mode)))
            contents_.candidates.push_back(candidate(parent, name, path, *part));
        else
            contents_.others.push_back(asUtf8(path));
    }

    [[nodiscard]] Candidate candidate(int parent, const std::string& name, const std::string& path,
                                      Part part) const {
        Candidate result{part, path, {}, {}};
        const OpenFile file{openat(parent, name.c_str(),
                                   O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)};
        struct stat status {};
        const bool isFile =
            file.get() >= 0 && fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode);
        const std::uint64_t limit = byteLimitOf(part, limits_);
        auto bytes = isFile ? readUpTo(file.get(), limit) : std::nullopt;
        if (!bytes)
            result.refusal = refusal(
                "intake.unsafe-archive",
                fmt::format("{} is no ordinary file that can be read: a link, a pipe or a device.",
                            raytracer::inQuotes(path)),
                "Hand in the file itself.");
        else if (bytes->size() > limit)
            result.refusal = tooLarge(path, limit);
        else
            result.bytes = std::move(*bytes);
        return result;
    }

    const IntakeLimits& limits_;
    Contents contents_;
    std::uint64_t members_ = 0;
};

}  // namespace

Contents readFolder(const std::filesystem::path& folder, const IntakeLimits& limits) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        throw raytracer::InputError(folder.string(), 0,
                                    "cannot be read: " + std::generic_category().message(errno));
    FolderReader reader{limits};
    reader.read(descriptor, "", 0);
    return reader.take();
}

}  // namespace ticker::intake
