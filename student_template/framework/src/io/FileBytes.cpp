#include "FileBytes.h"

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>
#include <raytracer/io/ImageWriter.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <random>
#include <string_view>
#include <system_error>
#include <vector>

namespace raytracer {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::string& message) {
    throw InputError(file.string(), 0, message);
}

/// "; did you mean bump-mapping.xml?" if the folder has a file with a similar name.
std::string nearbyFile(const fs::path& file) {
    std::error_code error;
    std::vector<std::string> names;
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    for (const fs::directory_entry& entry : fs::directory_iterator{folder, error})
        if (entry.path().extension() == file.extension())
            names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    const std::vector<std::string_view> known{names.begin(), names.end()};
    const std::string name = file.filename().string();
    const std::optional<std::string_view> nearest = nearestName(name, known);
    return nearest ? "; did you mean " + std::string(*nearest) + "?" : "";
}

/// A file that is removed on destruction unless it was renamed.
class TemporaryFile {
public:
    // The name is random, so that two programs that write the same picture use different files.
    explicit TemporaryFile(const fs::path& target)
        : path_(fs::path{target} += "." + std::to_string(std::random_device{}()) + ".part") {}
    ~TemporaryFile() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

    [[nodiscard]] std::error_code renameTo(const fs::path& target) {
        std::error_code error;
        fs::rename(path_, target, error);
        if (!error) path_.clear();
        return error;
    }

private:
    fs::path path_;
};

// Follows a symbolic link, so that its target is replaced and not the link.
fs::path resolved(const fs::path& file) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(file, error);
    return error ? file : target;
}

}  // namespace

std::string readFileBytes(const fs::path& file, std::size_t largest) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status)) fail(file, "there is no such file" + nearbyFile(file));
    if (fs::is_directory(status)) fail(file, "this is a folder, not a file");
    if (!fs::is_regular_file(status)) fail(file, "this is no regular file");

    std::ifstream in(file, std::ios::binary);
    if (!in) fail(file, "the file cannot be opened; check who may read it");
    std::string bytes;
    std::array<char, 65536> block{};
    while (in && bytes.size() <= largest) {
        in.read(block.data(), static_cast<std::streamsize>(block.size()));
        bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
    }
    if (in.bad()) fail(file, "the file cannot be read to its end");
    if (bytes.size() > largest)
        fail(file, "the file is larger than " + std::to_string(largest / 1048576) + " MiB");
    return bytes;
}

void checkWritable(const fs::path& file) {
    std::error_code error;
    if (!file.has_filename()) fail(file, "this names no file; add a file name");
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
        fail(file, "the folder " + folder.string() + " does not exist; make it first");
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status)) fail(file, "this is a folder; add a file name");
    if (fs::exists(status) && !fs::is_regular_file(status))
        fail(file, "this is no regular file and will not be replaced");
}

void replaceFile(const fs::path& file, const std::string& bytes) {
    checkWritable(file);
    const fs::path target = resolved(file);
    TemporaryFile temporary{target};
    std::ofstream out(temporary.path(), std::ios::binary);
    if (!out) fail(file, "no file can be made in this folder; check who may write to it");
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) fail(file, "the file cannot be written to its end; is the disk full?");
    if (const std::error_code error = temporary.renameTo(target))
        fail(file, "the file cannot be replaced: " + error.message());
}

}  // namespace raytracer
