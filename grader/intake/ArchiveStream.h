#ifndef TICKER_INTAKE_ARCHIVESTREAM_H
#define TICKER_INTAKE_ARCHIVESTREAM_H

#include <grader/base/FileDescriptor.h>
#include <grader/intake/Contents.h>

#include <locale.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

struct archive;
struct archive_entry;

namespace ticker::intake {

/// Makes this thread's character set UTF-8. libarchive returns no name of a zip with UTF-8 names to
/// a thread with another character set.
class Utf8Names {
public:
    Utf8Names();
    ~Utf8Names();
    Utf8Names(const Utf8Names&) = delete;
    Utf8Names& operator=(const Utf8Names&) = delete;

private:
    locale_t utf8_;
    locale_t before_;
};

/// The members of a zip or tar archive, one after the other, for one thread.
///
/// If the system cannot read the file, the functions throw. If the archive is damaged, or the file
/// is no archive, they do not: `damage` describes it.
class ArchiveStream {
public:
    /// @throws raytracer::InputError if the file cannot be read.
    explicit ArchiveStream(std::filesystem::path file);
    /// @param packed  Must outlive this object.
    explicit ArchiveStream(const Packed& packed);
    ~ArchiveStream() = default;
    ArchiveStream(const ArchiveStream&) = delete;
    ArchiveStream& operator=(const ArchiveStream&) = delete;

    /// The next member; null at the end, and where the archive is damaged.
    /// @throws raytracer::InputError if the file cannot be read.
    [[nodiscard]] archive_entry* next();

    /// Unpacks the next bytes of the member into the buffer.
    /// @return  Their number; 0 at the member's end; empty if they cannot be unpacked.
    /// @throws raytracer::InputError if the file cannot be read.
    [[nodiscard]] std::optional<std::size_t> unpackInto(std::string& buffer);

    /// Why the archive cannot be read to its end; empty if no damage was found so far.
    [[nodiscard]] const std::string& damage() const { return damage_; }
    /// Size of the archive itself, in bytes.
    [[nodiscard]] std::uint64_t packedBytes() const { return packedBytes_; }
    /// Empty for an archive in memory.
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

private:
    struct Free {
        void operator()(archive* handle) const;
    };
    struct Calls;  // what libarchive calls to read the file

    void noteDamage();

    Utf8Names utf8_;
    std::filesystem::path file_;
    FileDescriptor descriptor_;
    std::uint64_t packedBytes_ = 0;
    std::string block_;
    int readError_ = 0;  // errno of the file's last read
    std::unique_ptr<archive, Free> archive_;
    std::string damage_;
};

/// The path of a member, as the archive has it.
[[nodiscard]] std::string memberPath(archive_entry* entry);

}  // namespace ticker::intake

#endif
