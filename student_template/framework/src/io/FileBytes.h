#ifndef RAYTRACER_SRC_IO_FILEBYTES_H
#define RAYTRACER_SRC_IO_FILEBYTES_H

#include <cstddef>
#include <filesystem>
#include <string>

namespace raytracer {

/// Everything in a regular file.
/// @param largest  Bytes; no more than one byte beyond it is ever read.
/// @throws InputError where the file is missing, no regular file, unreadable or larger.
[[nodiscard]] std::string readFileBytes(const std::filesystem::path& file, std::size_t largest);

/// Replaces a file, whole or not at all: writes a temporary file beside it and renames that.
/// @throws InputError where the folder is missing or the file cannot be written.
void replaceFile(const std::filesystem::path& file, const std::string& bytes);

}  // namespace raytracer

#endif
