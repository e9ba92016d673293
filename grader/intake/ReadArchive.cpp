#include <grader/base/Utf8.h>
#include <grader/intake/ClassExport.h>
#include <grader/intake/Contents.h>
#include <grader/result/GeneralFindings.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <archive.h>
#include <archive_entry.h>
#include <locale.h>
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

/// Makes this thread's character set UTF-8. libarchive returns no name of a zip with UTF-8 names to
/// a thread with another character set.
class Utf8Names {
public:
    Utf8Names() : before_(uselocale(utf8_)) {}
    ~Utf8Names() {
        uselocale(before_);
        if (utf8_ != nullptr) freelocale(utf8_);
    }
    Utf8Names(const Utf8Names&) = delete;
    Utf8Names& operator=(const Utf8Names&) = delete;

private:
    locale_t utf8_ = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
    locale_t before_;
};

Archive newArchive() {
    Archive made{archive_read_new()};
    archive_read_support_format_zip(made.get());
    archive_read_support_format_tar(made.get());
    archive_read_support_filter_gzip(made.get());
    return made;
}

bool openFile(const Archive& reader, const std::filesystem::path& file) {
    constexpr std::size_t kBlock = 64U << 10U;
    return archive_read_open_filename(reader.get(), file.c_str(), kBlock) == ARCHIVE_OK;
}

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

/// Reads an archive to its end, or to the first member that is not allowed.
class ArchiveReader {
public:
    ArchiveReader(const std::filesystem::path& file, const IntakeLimits& limits,
                  const std::string& owner)
        : limits_(limits), owner_(owner), archive_(newArchive()) {
        packed_ = std::filesystem::file_size(file);
        isOpen_ = openFile(archive_, file);
    }

    ArchiveReader(const Packed& packed, const IntakeLimits& limits, const std::string& owner)
        : limits_(limits), owner_(owner), archive_(newArchive()), packed_(packed.bytes.size()) {
        isOpen_ = archive_read_open_memory(archive_.get(), packed.bytes.data(),
                                           packed.bytes.size()) == ARCHIVE_OK;
    }

    [[nodiscard]] Contents read() {
        const Utf8Names utf8;
        if (!isOpen_) return broken();
        if (packed_ > limits_.archiveBytes && owner_.empty()) {
            refuse(kIntakeTooLarge, "The archive is too large.");
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
        refuse(kIntakeUnsafeArchive, "The file is no zip or tar archive, or it is damaged.");
        return std::move(contents_);
    }

    void refuse(const FindingText& text, std::string message) {
        contents_.refusals.push_back(
            refusal(text, std::move(message),
                    "Make a fresh zip of the files that the exercise names, nothing else."));
    }

    void refuseMember(std::string_view path, const char* why) {
        refuse(kIntakeUnsafeArchive,
               fmt::format("The archive's member {} {}.", raytracer::inQuotes(path), why));
    }

    void readMember(archive_entry* entry) {
        std::string path = pathOf(entry);
        auto his = pathInWork(owner_, path);
        if (!his) return;
        path = std::move(*his);
        const auto type = archive_entry_filetype(entry);
        if (++members_ > limits_.members)
            return refuse(kIntakeTooLarge,
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

    // Every member is unpacked, in memory and piece by piece, so that bombs are found everywhere;
    // only candidates are kept.
    void readFile(const std::string& path) {
        const std::optional<std::string> part =
            isLitter(path) ? std::nullopt : partOf(path, *limits_.exercise);
        const bool isPacked = !part && !isLitter(path) && isArchive(path);
        Candidate candidate{part.value_or(""), path, {}, {}};
        const std::uint64_t limit =
            isPacked ? limits_.archiveBytes : byteLimitOf(candidate.part, limits_);
        std::string buffer(64U << 10U, '\0');
        for (;;) {
            const la_ssize_t size = archive_read_data(archive_.get(), buffer.data(), buffer.size());
            if (size < 0) return refuseMember(path, "cannot be unpacked");
            if (size == 0) break;
            unpacked_ += static_cast<std::uint64_t>(size);
            if (isBomb()) return refuseMember(path, "unpacks to far more than the archive holds");
            if ((part || isPacked) && candidate.bytes.size() <= limit)
                candidate.bytes.append(buffer, 0, static_cast<std::size_t>(size));
        }
        if (isPacked && candidate.bytes.size() <= limit) {
            contents_.archives.push_back({path, std::move(candidate.bytes)});
            return;
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
    const std::string& owner_;
    Archive archive_;
    bool isOpen_ = false;
    Contents contents_;
    std::uint64_t packed_ = 0;
    std::uint64_t unpacked_ = 0;
    std::uint64_t members_ = 0;
};

}  // namespace

Contents readArchive(const std::filesystem::path& file, const IntakeLimits& limits,
                     const std::string& owner) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
        throw raytracer::InputError(file.string(), 0, "no archive that can be read");
    return ArchiveReader{file, limits, owner}.read();
}

Contents readArchive(const Packed& packed, const IntakeLimits& limits) {
    return ArchiveReader{packed, limits, {}}.read();
}

std::vector<std::string> listArchive(const std::filesystem::path& file) {
    constexpr std::size_t kMost =
        1'000'000;  // enough for a class of thousands; stops a bomb of names
    std::vector<std::string> paths;
    const Archive reader = newArchive();
    if (!openFile(reader, file)) return paths;
    const Utf8Names utf8;
    archive_entry* entry = nullptr;
    while (paths.size() < kMost) {
        const int status = archive_read_next_header(reader.get(), &entry);
        if (status == ARCHIVE_EOF || status < ARCHIVE_WARN) break;
        paths.push_back(pathOf(entry));
    }
    return paths;
}

}  // namespace ticker::intake
