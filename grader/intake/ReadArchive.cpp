#include <grader/intake/Contents.h>
#include <grader/intake/Utf8.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <memory>
#include <string>
#include <system_error>

namespace ticker::intake {
namespace {

struct FreeArchive {
    void operator()(archive* handle) const { archive_read_free(handle); }
};
using Archive = std::unique_ptr<archive, FreeArchive>;

std::string pathOf(archive_entry* entry) {
    if (const char* name = archive_entry_pathname(entry)) return name;
    if (const char* name = archive_entry_pathname_utf8(entry)) return name;
    return "?";
}

bool escapes(std::string_view path) {
    if (path.starts_with('/') || path.starts_with('\\')) return true;
    if (path.size() > 1 && path[1] == ':') return true;
    std::size_t begin = 0;
    while (begin <= path.size()) {
        const std::size_t end = std::min(path.find_first_of("/\\", begin), path.size());
        if (path.substr(begin, end - begin) == "..") return true;
        begin = end + 1;
    }
    return false;
}

int depthOf(std::string_view path) {
    return static_cast<int>(std::count(path.begin(), path.end(), '/'));
}

/// Reads an archive from its beginning to its end, or to the first member that must not be.
class ArchiveReader {
public:
    ArchiveReader(const std::filesystem::path& file, const IntakeLimits& limits)
        : limits_(limits), archive_(archive_read_new()) {
        archive_read_support_format_zip(archive_.get());
        archive_read_support_format_tar(archive_.get());
        archive_read_support_filter_gzip(archive_.get());
        constexpr std::size_t kBlock = 64U << 10U;
        packed_ = std::filesystem::file_size(file);
        isOpen_ = archive_read_open_filename(archive_.get(), file.c_str(), kBlock) == ARCHIVE_OK;
    }

    [[nodiscard]] Contents read() {
        if (!isOpen_) return broken();
        if (packed_ > limits_.archiveBytes) {
            refuse("intake.too-large", "The archive is too large.");
            return std::move(contents_);
        }
        archive_entry* entry = nullptr;
        int status = ARCHIVE_OK;
        while (contents_.refusals.empty() &&
               (status = archive_read_next_header(archive_.get(), &entry)) >= ARCHIVE_WARN &&
               status != ARCHIVE_EOF)
            readMember(entry);
        if (contents_.refusals.empty() && status != ARCHIVE_EOF) return broken();
        return std::move(contents_);
    }

private:
    Contents broken() {
        refuse("intake.unsafe-archive", "The file is no zip or tar archive, or it is damaged.");
        return std::move(contents_);
    }

    void refuse(const char* id, std::string message) {
        contents_.refusals.push_back(
            refusal(id, std::move(message),
                    "Make a fresh zip of the files that the exercise names, nothing else."));
    }

    void refuseMember(std::string_view path, const char* why) {
        refuse("intake.unsafe-archive",
               fmt::format("The archive's member {} {}.", raytracer::inQuotes(path), why));
    }

    void readMember(archive_entry* entry) {
        const std::string path = pathOf(entry);
        const auto type = archive_entry_filetype(entry);
        if (++members_ > limits_.members)
            return refuse("intake.too-large",
                          fmt::format("The archive has more than {} members, from {} on.",
                                      limits_.members, raytracer::inQuotes(path)));
        if (escapes(path)) return refuseMember(path, "would be unpacked outside its folder");
        if (depthOf(path) > limits_.depth) return refuseMember(path, "lies too deep in folders");
        if (archive_entry_hardlink(entry) != nullptr || archive_entry_symlink(entry) != nullptr ||
            type == AE_IFLNK)
            return refuseMember(path, "is a link");
        // GNU tar's folders may have contents, which would be unpacked only to be skipped.
        if (type == AE_IFDIR && archive_entry_size(entry) > 0)
            return refuseMember(path, "is a folder with contents");
        if (type == AE_IFDIR) return;
        if (type != AE_IFREG && type != 0) return refuseMember(path, "is a device or a pipe");
        if (archive_entry_is_encrypted(entry) != 0) return refuseMember(path, "is encrypted");
        readFile(path);
    }

    // Every member is unpacked, in memory and piece by piece, so that bombs are found wherever
    // they are; only candidates are kept.
    void readFile(const std::string& path) {
        const std::optional<Part> part = isLitter(path) ? std::nullopt : partOf(path);
        Candidate candidate{part.value_or(Part::renderer), path, {}, {}};
        const std::uint64_t limit = byteLimitOf(candidate.part, limits_);
        std::string buffer(64U << 10U, '\0');
        for (;;) {
            const la_ssize_t size = archive_read_data(archive_.get(), buffer.data(), buffer.size());
            if (size < 0) return refuseMember(path, "cannot be unpacked");
            if (size == 0) break;
            unpacked_ += static_cast<std::uint64_t>(size);
            if (isBomb()) return refuseMember(path, "unpacks to far more than the archive holds");
            if (part && candidate.bytes.size() <= limit)
                candidate.bytes.append(buffer, 0, static_cast<std::size_t>(size));
        }
        if (!part) {
            contents_.others.push_back(asUtf8(path));
            return;
        }
        if (candidate.bytes.size() > limit) {
            candidate.bytes.clear();
            candidate.refusal = tooLarge(path, limit);
        }
        contents_.candidates.push_back(std::move(candidate));
    }

    [[nodiscard]] bool isBomb() const {
        return unpacked_ > limits_.unpackedBytes ||
               (unpacked_ > limits_.ratioFreeBytes &&
                static_cast<double>(unpacked_) >
                    limits_.largestRatio * static_cast<double>(packed_));
    }

    const IntakeLimits& limits_;
    Archive archive_;
    bool isOpen_ = false;
    Contents contents_;
    std::uint64_t packed_ = 0;
    std::uint64_t unpacked_ = 0;
    std::uint64_t members_ = 0;
};

}  // namespace

Contents readArchive(const std::filesystem::path& file, const IntakeLimits& limits) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
        throw raytracer::InputError(file.string(), 0, "no archive that can be read");
    return ArchiveReader{file, limits}.read();
}

}  // namespace ticker::intake
