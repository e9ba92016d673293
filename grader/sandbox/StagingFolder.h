#ifndef TICKER_SANDBOX_STAGINGFOLDER_H
#define TICKER_SANDBOX_STAGINGFOLDER_H

#include <grader/base/FileDescriptor.h>

#include <filesystem>
#include <string>

namespace ticker::sandbox {

/// A folder of this process, gone with it, that every user can walk through but nobody can list:
/// what lies in it is reached only by who was told its name. A later process removes what one left
/// that was killed.
class StagingFolder {
public:
    /// @throws raytracer::Error where no place of this machine will do.
    StagingFolder();
    ~StagingFolder();
    StagingFolder(const StagingFolder&) = delete;
    StagingFolder& operator=(const StagingFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// A new folder in it with a name that cannot be guessed. @param mode  As for chmod.
    [[nodiscard]] std::filesystem::path makeFolder(std::filesystem::perms mode) const;

private:
    std::filesystem::path path_;
    FileDescriptor lock_;
};

/// 128 random bits in hexadecimal.
[[nodiscard]] std::string randomName();

}  // namespace ticker::sandbox

#endif
