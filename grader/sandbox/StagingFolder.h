#ifndef TICKER_SANDBOX_STAGINGFOLDER_H
#define TICKER_SANDBOX_STAGINGFOLDER_H

#include <grader/base/FileDescriptor.h>

#include <filesystem>
#include <string>

namespace ticker::sandbox {

/// A folder of this process, removed when the process ends. Every user can pass through it, but not
/// list it: its contents can be reached only by name. If the process was killed, a later one
/// removes the folder.
class StagingFolder {
public:
    /// @throws raytracer::Error if no folder of this machine is suitable.
    StagingFolder();
    ~StagingFolder();
    StagingFolder(const StagingFolder&) = delete;
    StagingFolder& operator=(const StagingFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Makes a folder in it with an unguessable name. @param mode  As for chmod.
    [[nodiscard]] std::filesystem::path makeFolder(std::filesystem::perms mode) const;

private:
    std::filesystem::path path_;
    FileDescriptor lock_;
};

/// True if every job can reach the folder. As root, jobs run under another uid, which needs search
/// permission on every folder of the path.
/// @param folder  An absolute path.
[[nodiscard]] bool jobsCanReach(const std::filesystem::path& folder);

/// 128 random bits in hexadecimal.
[[nodiscard]] std::string randomName();

}  // namespace ticker::sandbox

#endif
