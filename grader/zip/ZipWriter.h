#ifndef TICKER_ZIP_ZIPWRITER_H
#define TICKER_ZIP_ZIPWRITER_H

#include <grader/base/WholeFile.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace ticker::zip {

/// Writes one zip file. Until `finish` nothing of that name appears; without it, nothing is left.
class ZipWriter {
public:
    /// @throws raytracer::InputError where the file cannot be written.
    explicit ZipWriter(std::filesystem::path file);
    ~ZipWriter();
    ZipWriter(const ZipWriter&) = delete;
    ZipWriter& operator=(const ZipWriter&) = delete;

    /// Adds one file. @param name  Path inside, UTF-8, with '/' between folders.
    /// @throws raytracer::InputError where the disk is full.
    void add(const std::string& name, std::string_view bytes, bool isProgram = false);

    /// Adds a file of this machine; it is a program inside where its owner may run it.
    /// @throws raytracer::InputError where it cannot be read.
    void addFile(const std::string& name, const std::filesystem::path& file);

    /// Adds all regular files below a folder, by name. Symbolic links are followed.
    /// @throws raytracer::InputError where something cannot be read.
    void addFolder(const std::string& name, const std::filesystem::path& folder);

    /// Puts the file into its place.
    /// @throws raytracer::InputError where that fails.
    void finish();

private:
    struct Archive;

    std::filesystem::path file_;
    PartFile part_;
    std::unique_ptr<Archive> archive_;
};

}  // namespace ticker::zip

#endif
