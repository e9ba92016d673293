#include <grader/base/Utf8.h>
#include <grader/intake/ClassExport.h>
#include <grader/intake/Contents.h>
#include <grader/result/GeneralFindings.h>

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

/// Walks through a folder by descriptors, so that no link can be substituted during the walk.
class FolderReader {
public:
    FolderReader(const IntakeLimits& limits, const std::string& owner)
        : limits_(limits), owner_(owner) {}

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
            if (name == "." || name == ".." || !isHis(prefix + name)) continue;
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
    [[nodiscard]] bool isHis(const std::string& path) const {
        return path.find('/') != std::string::npos || pathInWork(owner_, path);
    }

    void refuseCount() {
        contents_.refusals.push_back(
            refusal(kIntakeTooLarge, fmt::format("More than {} files.", limits_.members),
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
        take(parent, name, pathInWork(owner_, path).value_or(path),
             known && S_ISREG(status.st_mode), known && S_ISDIR(status.st_mode));
    }

    void take(int parent, const std::string& name, const std::string& path, bool isFile,
              bool isFolder) {
        const std::optional<std::string> part =
            isLitter(path) ? std::nullopt : partOf(path, *limits_.exercise);
        if (part && !isFolder)
            contents_.candidates.push_back(candidate(parent, name, path, *part));
        else if (auto packed = isFile ? archiveAt(parent, name, path) : std::nullopt)
            contents_.archives.push_back({path, std::move(*packed)});
        else
            contents_.others.push_back(asUtf8(path));
    }

    /// The bytes of an archive; empty if it is not one, or if all archives together are too large.
    [[nodiscard]] std::optional<std::string> archiveAt(int parent, const std::string& name,
                                                       const std::string& path) {
        if (isLitter(path) || !isArchive(path)) return std::nullopt;
        auto bytes = bytesAt(parent, name, limits_.archiveBytes - packedBytes_);
        if (!bytes || packedBytes_ + bytes->size() > limits_.archiveBytes) return std::nullopt;
        packedBytes_ += bytes->size();
        return bytes;
    }

    /// At most limit + 1 bytes of a regular file; empty if it is not one.
    [[nodiscard]] static std::optional<std::string> bytesAt(int parent, const std::string& name,
                                                            std::uint64_t limit) {
        const OpenFile file{openat(parent, name.c_str(),
                                   O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)};
        struct stat status {};
        const bool isFile =
            file.get() >= 0 && fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode);
        return isFile ? readUpTo(file.get(), limit) : std::nullopt;
    }

    [[nodiscard]] Candidate candidate(int parent, const std::string& name, const std::string& path,
                                      const std::string& part) const {
        Candidate result{part, path, {}, {}};
        const std::uint64_t limit = byteLimitOf(part, limits_);
        auto bytes = bytesAt(parent, name, limit);
        if (!bytes)
            result.refusal = refusal(
                kIntakeUnsafeArchive,
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
    const std::string& owner_;
    Contents contents_;
    std::uint64_t members_ = 0;
    std::uint64_t packedBytes_ = 0;
};

}  // namespace

Contents readFolder(const std::filesystem::path& folder, const IntakeLimits& limits,
                    const std::string& owner) {
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        throw raytracer::InputError(folder.string(), 0,
                                    "cannot be read: " + std::generic_category().message(errno));
    FolderReader reader{limits, owner};
    reader.read(descriptor, "", 0);
    return reader.take();
}

}  // namespace ticker::intake
