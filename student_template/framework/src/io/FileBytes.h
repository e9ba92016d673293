#ifndef RAYTRACER_SRC_IO_FILEBYTES_H
#define RAYTRACER_SRC_IO_FILEBYTES_H

#include <cstddef>
#include <filesystem>
#include <string>

namespace raytracer {

/// The contents of a regular file.
/// @param largest  Bytes; at most one byte more is read.
/// @throws InputError if the file is missing, not regular, unreadable or larger.
[[nodiscard]] std::string readFileBytes(const std::filesystem::path& file, std::size_t largest);

/// Replaces a file atomically: writes a temporary file beside it and renames that.
/// @throws InputError if the folder is missing or the file cannot be written.
void replaceFile(const std::filesystem::path& file, const std::string& bytes);

}  // namespace raytracer

#endif
