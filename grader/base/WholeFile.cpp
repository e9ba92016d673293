#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <unistd.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <utility>

namespace ticker {

namespace fs = std::filesystem;
using raytracer::InputError;

std::optional<std::string> readIfThere(const fs::path& file) {
    std::ifstream stream{file, std::ios::binary};
    std::string bytes;
    std::array<char, 65536> piece{};
    // A folder can be opened, but not read; unlike iterators read() reports that without
    // exceptions.
    while (stream) {
        stream.read(piece.data(), piece.size());
        bytes.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (!stream.eof()) return std::nullopt;
    return bytes;
}

std::string readWhole(const fs::path& file, std::string_view complaint) {
    std::optional<std::string> bytes = readIfThere(file);
    if (!bytes) throw InputError(file.string(), 0, std::string{complaint});
    return std::move(*bytes);
}

PartFile::PartFile(fs::path target)
    : target_(std::move(target)),
      path_(target_.parent_path() /
            ("." + target_.filename().string() + "." + std::to_string(::getpid()) + ".part")) {}

PartFile::~PartFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
}

bool PartFile::write(std::string_view bytes) const {
    std::ofstream stream{path_, std::ios::binary | std::ios::trunc};
    stream << bytes;
    stream.close();
    return static_cast<bool>(stream);
}

std::error_code PartFile::rename() const {
    std::error_code error;
    fs::rename(path_, target_, error);
    return error;
}

void writeAtomically(std::string_view bytes, const fs::path& file) {
    const PartFile part{file};
    if (!part.write(bytes) || part.rename())
        throw InputError(file.string(), 0,
                         "cannot be written; is the folder there and the disk not full?");
}

}  // namespace ticker
