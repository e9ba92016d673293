#ifndef TICKER_CLI_FOLDERLOCK_H
#define TICKER_CLI_FOLDERLOCK_H

#include <grader/base/FileDescriptor.h>

#include <filesystem>

namespace ticker::cli {

/// Lock of a folder of results: two graders at once would mix their seeds. The kernel releases it
/// when the process ends in any way. Incomplete files of a killed process are removed.
class FolderLock {
public:
    /// @throws raytracer::InputError if another process holds the lock. On a file system without
    ///         locks there is no protection.
    explicit FolderLock(const std::filesystem::path& folder);

private:
    FileDescriptor file_;
};

}  // namespace ticker::cli

#endif
