#ifndef TICKER_BASE_MAKEFOLDER_H
#define TICKER_BASE_MAKEFOLDER_H

#include <raytracer/base/Error.h>

#include <filesystem>
#include <system_error>

namespace ticker {

/// Creates a folder and those above it, unless they are there.
/// @throws raytracer::InputError with the folder and the system's reason.
inline void makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw raytracer::InputError(folder.string(), 0, "cannot be made: " + error.message());
}

}  // namespace ticker

#endif
