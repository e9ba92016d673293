#include <grader/base/FileDescriptor.h>
#include <grader/base/Utf8.h>
#include <grader/intake/ClassExport.h>
#include <grader/intake/Contents.h>
#include <grader/intake/OutFolder.h>
#include <grader/result/GeneralFindings.h>

#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <utility>

namespace ticker::intake {
namespace {

struct CloseFolder {
    void operator()(DIR* folder) const { closedir(folder); }
};
using Folder = std::unique_ptr<DIR, CloseFolder>;

// At most limit + 1 bytes, so that a file that grows while it is read is noticed. Empty: it cannot
// be read, and errno says why.
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

/// Walks through a folder by descriptors, so that no link can be substituted during the walk.
///
/// A file or folder that the system does not let us read throws: it is not missing, and no
/// student's fault.
class FolderReader {
public:
    FolderReader(const std::filesystem::path& top, const IntakeLimits& limits,
                 const std::string& owner, const std::filesystem::path& out)
        : top_(top), limits_(limits), owner_(owner), out_(out) {}

    void read(FileDescriptor opened, const std::string& prefix, int depth) {
        const Folder folder{fdopendir(opened.get())};
        if (!folder) fail(prefix);
        opened.release();
        std::vector<std::string> names;
        for (;;) {
            errno = 0;
            // NOLINTNEXTLINE(concurrency-mt-unsafe): each stream is read by one thread
            const dirent* entry = readdir(folder.get());
            if (entry == nullptr && errno != 0) fail(prefix);
            if (entry == nullptr) break;
            const std::string name{entry->d_name};
            if (name == "." || name == ".." || !belongsToOwner(prefix + name)) continue;
            names.push_back(name);
            if (++members_ > limits_.members) return refuseCount();
        }
        std::ranges::sort(names);
        for (const std::string& name : names)
            visit(dirfd(folder.get()), name, prefix + name, depth);
    }

    [[nodiscard]] Contents take() { return std::move(contents_); }

private:
    // In a folder, the first level alone decides the owner.
    [[nodiscard]] bool belongsToOwner(const std::string& path) const {
        return path.find('/') != std::string::npos || pathInWork(owner_, path);
    }

    void refuseCount() {
        contents_.refusals.push_back(
            refusal(kIntakeTooLarge, fmt::format("More than {} files.", limits_.members),
                    "Hand in the two or three files that the exercise names."));
    }

    void visit(int parent, const std::string& name, const std::string& path, int depth) {
        struct stat status {};
        if (fstatat(parent, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
            if (errno == ENOENT) return;  // removed meanwhile
            fail(path);
        }
        if (S_ISDIR(status.st_mode) && !isLitter(path) && depth < limits_.depth &&
            !isOut(top_ / path, {*limits_.exercise, out_})) {
            FileDescriptor child{
                openat(parent, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)};
            if (child.isOpen()) return read(std::move(child), path + "/", depth + 1);
            if (!isReplaced(errno)) fail(path);
        }
        take(parent, name, path, S_ISREG(status.st_mode), S_ISDIR(status.st_mode));
    }

    // A link or another kind of file took the place of the one that was there.
    [[nodiscard]] static bool isReplaced(int error) {
        return error == ELOOP || error == ENOTDIR || error == ENXIO;
    }

    [[noreturn]] void fail(const std::string& path) const {
        const int error = errno;
        throw unreadable(top_ / path, error);
    }

    /// @param place  The path in the folder; the owner's own path is a part of it.
    void take(int parent, const std::string& name, const std::string& place, bool isFile,
              bool isFolder) {
        const std::string path = pathInWork(owner_, place).value_or(place);
        const std::optional<std::string> part =
            isLitter(path) ? std::nullopt : partOf(path, *limits_.exercise);
        const auto bytesUpTo = [&](std::uint64_t limit) {
            return isFile ? bytesAt(parent, name, place, limit) : std::nullopt;
        };
        if (part && !isFolder)
            contents_.candidates.push_back(
                candidate(bytesUpTo(byteLimitOf(*part, limits_)), path, *part));
        else if (isFile && !isLitter(path) && isArchive(path))
            takeArchive(bytesUpTo(limits_.archiveBytes - packedBytes_), path);
        else
            contents_.others.push_back(asUtf8(path));
    }

    // Ignores an archive with which all archives together would be too large.
    void takeArchive(std::optional<std::string> bytes, const std::string& path) {
        if (!bytes || packedBytes_ + bytes->size() > limits_.archiveBytes) {
            contents_.others.push_back(asUtf8(path));
            return;
        }
        packedBytes_ += bytes->size();
        contents_.archives.push_back({path, std::move(*bytes)});
    }

    /// At most limit + 1 bytes of a regular file; empty if another kind of file has replaced it.
    [[nodiscard]] std::optional<std::string> bytesAt(int parent, const std::string& name,
                                                     const std::string& place,
                                                     std::uint64_t limit) const {
        const FileDescriptor file{openat(
            parent, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)};
        if (!file.isOpen() && isReplaced(errno)) return std::nullopt;
        struct stat status {};
        if (!file.isOpen() || fstat(file.get(), &status) != 0) fail(place);
        if (!S_ISREG(status.st_mode)) return std::nullopt;
        std::optional<std::string> bytes = readUpTo(file.get(), limit);
        if (!bytes) fail(place);
        return bytes;
    }

    [[nodiscard]] Candidate candidate(std::optional<std::string> bytes, const std::string& path,
                                      const std::string& part) const {
        Candidate result{part, path, {}, {}};
        const std::uint64_t limit = byteLimitOf(part, limits_);
        if (!bytes)
            result.refusal = refusal(
                kIntakeUnsafeArchive,
                fmt::format("{} is no ordinary file that can be read: a link, a pipe or a device.",
                            raytracer::inQuotes(path)),
                "Hand in the file itself.");
        else if (bytes->size() > limit)
            result.refusal = tooLarge(path, limit, *limits_.exercise);
        else
            result.bytes = std::move(*bytes);
        return result;
    }

    const std::filesystem::path& top_;
    const IntakeLimits& limits_;
    const std::string& owner_;
    const std::filesystem::path& out_;
    Contents contents_;
    std::uint64_t members_ = 0;
    std::uint64_t packedBytes_ = 0;
};

}  // namespace

Contents readFolder(const std::filesystem::path& folder, const IntakeLimits& limits,
                    const std::string& owner, const std::filesystem::path& out) {
    FileDescriptor opened{open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    if (!opened.isOpen()) throw unreadable(folder, errno);
    FolderReader reader{folder, limits, owner, out};
    reader.read(std::move(opened), "", 0);
    return reader.take();
}

}  // namespace ticker::intake
