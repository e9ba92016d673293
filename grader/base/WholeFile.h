#ifndef TICKER_BASE_WHOLEFILE_H
#define TICKER_BASE_WHOLEFILE_H

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace ticker {

/// The bytes of a file. Empty optional: it cannot be opened or read, or is a folder.
[[nodiscard]] std::optional<std::string> readIfThere(const std::filesystem::path& file);

/// The bytes of a file.
/// @throws raytracer::InputError with the file and `complaint` where it cannot be read.
[[nodiscard]] std::string readWhole(const std::filesystem::path& file,
                                    std::string_view complaint = "cannot be read");

/// A file beside `target` that takes its name once it is whole, and that goes away otherwise. Its
/// name is ".NAME.PID.part".
class PartFile {
public:
    explicit PartFile(std::filesystem::path target);
    ~PartFile();
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Writes the whole content. False: it could not be written.
    [[nodiscard]] bool write(std::string_view bytes) const;
    /// Replaces the target. An error leaves the target as it was.
    [[nodiscard]] std::error_code rename() const;

private:
    std::filesystem::path target_;
    std::filesystem::path path_;
};

/// Replaces a file by one with these bytes, whole or not at all.
/// @throws raytracer::InputError where it cannot be written.
void writeAtomically(std::string_view bytes, const std::filesystem::path& file);

}  // namespace ticker

#endif
