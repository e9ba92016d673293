#include <grader/zip/ZipWriter.h>

#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

namespace ticker::zip {
namespace {

namespace fs = std::filesystem;
using raytracer::InputError;

// 2 January 1980. The format has no times before 1 January; one day more keeps the local time after
// that in every time zone.
constexpr std::time_t kTime = 315532800 + 24 * 3600;

}  // namespace

struct ZipWriter::Archive {
    std::unique_ptr<::archive, decltype(&archive_write_free)> handle{archive_write_new(),
                                                                     archive_write_free};

    void require(la_ssize_t status, const fs::path& file) const {
        if (status < ARCHIVE_WARN)
            throw InputError(file.string(), 0, archive_error_string(handle.get()));
    }
};

ZipWriter::ZipWriter(fs::path file)
    : file_(std::move(file)), part_(file_), archive_(std::make_unique<Archive>()) {
    ::archive* const handle = archive_->handle.get();
    archive_->require(archive_write_set_format_zip(handle), file_);
    archive_->require(archive_write_set_options(handle, "zip:hdrcharset=UTF-8"), file_);
    archive_->require(archive_write_open_filename(handle, part_.path().c_str()), file_);
}

ZipWriter::~ZipWriter() = default;

void ZipWriter::add(const std::string& name, std::string_view bytes, bool isProgram) {
    const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry{archive_entry_new(),
                                                                              archive_entry_free};
    archive_entry_set_pathname_utf8(entry.get(), name.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), isProgram ? 0755 : 0644);
    archive_entry_set_mtime(entry.get(), kTime, 0);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
    archive_->require(archive_write_header(archive_->handle.get(), entry.get()), file_);
    archive_->require(archive_write_data(archive_->handle.get(), bytes.data(), bytes.size()),
                      file_);
}

void ZipWriter::addFile(const std::string& name, const fs::path& file) {
    std::error_code error;
    const fs::perms permissions = fs::status(file, error).permissions();
    add(name, readWhole(file), (permissions & fs::perms::owner_exec) != fs::perms::none);
}

void ZipWriter::addFolder(const std::string& name, const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::recursive_directory_iterator at{folder, error}, end; !error && at != end;
         at.increment(error))
        if (at->is_regular_file()) files.push_back(at->path());
    if (error) throw InputError(folder.string(), 0, "cannot be read: " + error.message());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
        addFile(name + "/" + file.lexically_relative(folder).generic_string(), file);
}

void ZipWriter::finish() {
    archive_->require(archive_write_close(archive_->handle.get()), file_);
    if (const std::error_code error = part_.rename())
        throw InputError(file_.string(), 0, "cannot be written: " + error.message());
}

}  // namespace ticker::zip
