#include <grader/base/Utf8.h>
#include <grader/intake/ArchiveStream.h>
#include <grader/intake/ClassExport.h>
#include <grader/intake/Contents.h>
#include <grader/result/GeneralFindings.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <string>

namespace ticker::intake {
namespace {

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
        : limits_(limits), owner_(owner), stream_(file) {}

    ArchiveReader(const Packed& packed, const IntakeLimits& limits, const std::string& owner,
                  const Unpacked& before)
        : limits_(limits), owner_(owner), stream_(packed) {
        contents_.unpacked = before;
    }

    [[nodiscard]] Contents read() {
        if (!stream_.damage().empty()) return broken();
        if (stream_.packedBytes() > limits_.archiveBytes && owner_.empty()) {
            refuse(kIntakeTooLarge, "The archive is too large.");
            return std::move(contents_);
        }
        while (archive_entry* entry = contents_.refusals.empty() ? stream_.next() : nullptr)
            readMember(entry);
        if (contents_.refusals.empty() && !stream_.damage().empty()) return broken();
        return std::move(contents_);
    }

private:
    Contents broken() {
        expectNoDownload();
        refuse(kIntakeUnsafeArchive, "The file is no zip or tar archive, or it is damaged.");
        return std::move(contents_);
    }

    // The archive of a class download is no student's hand-in: its damage is an error, no finding.
    void expectNoDownload() const {
        if (!owner_.empty()) throw damagedDownload(stream_.file(), stream_.damage());
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
        std::string path = memberPath(entry);
        auto pathInside = pathInWork(owner_, path);
        if (!pathInside) return;
        path = std::move(*pathInside);
        const auto type = archive_entry_filetype(entry);
        if (++contents_.unpacked.members > limits_.members)
            return refuse(kIntakeTooLarge,
                          fmt::format("The archive has more than {} members, from {} on.",
                                      limits_.members, raytracer::inQuotes(path)));
        if (path.size() > limits_.pathBytes) return refuseMember(path, "has too long a name");
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
            const std::optional<std::size_t> size = stream_.unpackInto(buffer);
            if (!size) {
                expectNoDownload();
                return refuseMember(path, "cannot be unpacked");
            }
            if (*size == 0) break;
            contents_.unpacked.bytes += *size;
            ownBytes_ += *size;
            if (isBomb()) return refuseMember(path, "unpacks to far more than the archive holds");
            if ((part || isPacked) && candidate.bytes.size() <= limit)
                candidate.bytes.append(buffer, 0, *size);
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
            candidate.refusal = tooLarge(path, limit, *limits_.exercise);
        }
        contents_.candidates.push_back(std::move(candidate));
    }

    [[nodiscard]] bool isBomb() const {
        const std::uint64_t all = contents_.unpacked.bytes;
        return all > limits_.unpackedBytes ||
               (all > limits_.ratioFreeBytes &&
                static_cast<double>(ownBytes_) >
                    limits_.largestRatio * static_cast<double>(stream_.packedBytes()));
    }

    const IntakeLimits& limits_;
    const std::string& owner_;
    ArchiveStream stream_;
    Contents contents_;
    std::uint64_t ownBytes_ = 0;  // unpacked, of this archive alone
};

}  // namespace

Contents readArchive(const std::filesystem::path& file, const IntakeLimits& limits,
                     const std::string& owner) {
    return ArchiveReader{file, limits, owner}.read();
}

Contents readArchive(const Packed& packed, const IntakeLimits& limits, const Unpacked& before) {
    return ArchiveReader{packed, limits, {}, before}.read();
}

MemberList listArchive(const std::filesystem::path& file, std::uint64_t mostBytes) {
    constexpr std::size_t kMost = 1'000'000;
    ArchiveStream stream{file};
    MemberList list;
    std::uint64_t bytes = 0;
    while (archive_entry* entry = stream.next()) {
        std::string path = memberPath(entry);
        bytes += path.size();
        if (bytes > mostBytes || list.paths.size() == kMost) {
            list.damage =
                fmt::format("the names of its files are too long, or more than {}", kMost);
            return list;
        }
        list.paths.push_back(std::move(path));
    }
    list.damage = stream.damage();
    return list;
}

}  // namespace ticker::intake
