#include <grader/intake/ArchiveStream.h>

#include <grader/base/Utf8.h>

#include <raytracer/base/Error.h>

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace ticker::intake {
namespace {

archive* newArchive() {
    archive* made = archive_read_new();
    archive_read_support_format_zip(made);
    archive_read_support_format_tar(made);
    archive_read_support_filter_gzip(made);
    return made;
}

}  // namespace

Utf8Names::Utf8Names()
    : utf8_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)), before_(uselocale(utf8_)) {}

Utf8Names::~Utf8Names() {
    uselocale(before_);
    if (utf8_ != nullptr) freelocale(utf8_);
}

void ArchiveStream::Free::operator()(archive* handle) const {
    archive_read_free(handle);
}

// libarchive's own reader of files reports an error of the disk like a damaged archive.
struct ArchiveStream::Calls {
    static la_ssize_t read(archive* handle, void* stream, const void** bytes) {
        auto& self = *static_cast<ArchiveStream*>(stream);
        ssize_t size = -1;
        do
            size = ::read(self.descriptor_.get(), self.block_.data(), self.block_.size());
        while (size < 0 && errno == EINTR);
        if (size < 0) {
            self.readError_ = errno;
            archive_set_error(handle, errno, "the file cannot be read");
        }
        *bytes = self.block_.data();
        return size;
    }

    // lseek also moves beyond the end of a file, so that the step is limited to what is left.
    static la_int64_t skip(archive* /*handle*/, void* stream, la_int64_t bytes) {
        auto& self = *static_cast<ArchiveStream*>(stream);
        const off_t from = lseek(self.descriptor_.get(), 0, SEEK_CUR);
        const auto left = static_cast<la_int64_t>(self.packedBytes_) - from;
        const la_int64_t step = std::min(bytes, left);
        if (from < 0 || step <= 0) return 0;
        return lseek(self.descriptor_.get(), step, SEEK_CUR) < 0 ? 0 : step;
    }

    static la_int64_t seek(archive* /*handle*/, void* stream, la_int64_t to, int from) {
        const off_t place = lseek(static_cast<ArchiveStream*>(stream)->descriptor_.get(), to, from);
        return place < 0 ? ARCHIVE_FATAL : place;
    }
};

ArchiveStream::ArchiveStream(std::filesystem::path file)
    : file_(std::move(file)),
      descriptor_(open(file_.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)),
      archive_(newArchive()) {
    if (!descriptor_.isOpen()) throw unreadable(file_, errno);
    struct stat status {};
    if (fstat(descriptor_.get(), &status) != 0) throw unreadable(file_, errno);
    if (!S_ISREG(status.st_mode))
        throw raytracer::InputError(asPlainLine(file_.string()), 0, "no archive that can be read");
    packedBytes_ = static_cast<std::uint64_t>(status.st_size);
    constexpr std::size_t kBlock = 64U << 10U;
    block_.resize(kBlock);
    archive* const handle = archive_.get();
    archive_read_set_read_callback(handle, Calls::read);
    archive_read_set_skip_callback(handle, Calls::skip);
    archive_read_set_seek_callback(handle, Calls::seek);
    archive_read_set_callback_data(handle, this);
    if (archive_read_open1(handle) != ARCHIVE_OK) noteDamage();
}

ArchiveStream::ArchiveStream(const Packed& packed)
    : packedBytes_(packed.bytes.size()), archive_(newArchive()) {
    if (archive_read_open_memory(archive_.get(), packed.bytes.data(), packed.bytes.size()) !=
        ARCHIVE_OK)
        noteDamage();
}

archive_entry* ArchiveStream::next() {
    archive_entry* entry = nullptr;
    const int status = damage_.empty() ? archive_read_next_header(archive_.get(), &entry)
                                       : static_cast<int>(ARCHIVE_EOF);
    if (status == ARCHIVE_EOF) return nullptr;
    if (status >= ARCHIVE_WARN) return entry;
    noteDamage();
    return nullptr;
}

std::optional<std::size_t> ArchiveStream::unpackInto(std::string& buffer) {
    const la_ssize_t size = archive_read_data(archive_.get(), buffer.data(), buffer.size());
    if (size >= 0) return static_cast<std::size_t>(size);
    noteDamage();
    return std::nullopt;
}

void ArchiveStream::noteDamage() {
    if (readError_ != 0) throw unreadable(file_, readError_);
    const char* const text = archive_error_string(archive_.get());
    damage_ = text == nullptr || *text == '\0' ? "its end is missing" : asPlainLine(text);
}

std::string memberPath(archive_entry* entry) {
    if (const char* name = archive_entry_pathname(entry)) return name;
    if (const char* name = archive_entry_pathname_utf8(entry)) return name;
    return "?";
}

}  // namespace ticker::intake
