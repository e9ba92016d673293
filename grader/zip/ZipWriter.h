#ifndef TICKER_ZIP_ZIPWRITER_H
#define TICKER_ZIP_ZIPWRITER_H

#include <grader/base/WholeFile.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace ticker::zip {

/// Writes one zip file. The file appears only after `finish`; without `finish`, nothing is left.
class ZipWriter {
public:
    /// @throws raytracer::InputError if the file cannot be written.
    explicit ZipWriter(std::filesystem::path file);
    ~ZipWriter();
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;

    /// Adds one file.
    /// @param name       Path in the archive, UTF-8, with '/' between folders.
    /// @param isProgram  Marks the file as executable.
    /// @throws raytracer::InputError if the disk is full.
    void add(const std::string& name, std::string_view bytes, bool isProgram = false);

    /// Adds a file of this machine; it is marked as executable if its owner may execute it.
    /// @throws raytracer::InputError if it cannot be read.
    void addFile(const std::string& name, const std::filesystem::path& file);

    /// Adds all regular files below a folder, in order of their names. Symbolic links are followed.
    /// @throws raytracer::InputError if a file cannot be read.
    void addFolder(const std::string& name, const std::filesystem::path& folder);

    /// Completes the file and moves it into place.
    /// @throws raytracer::InputError if that fails.
    void finish();

private:
    struct Archive;

    std::filesystem::path file_;
    PartFile part_;
    std::unique_ptr<Archive> archive_;
};

}  // namespace ticker::zip

#endif
