#ifndef TICKER_CLI_FOLDERLOCK_H
#define TICKER_CLI_FOLDERLOCK_H

#include <grader/base/FileDescriptor.h>

#include <filesystem>

namespace ticker::cli {

/// Keeps a second grader out of a folder of results: two at once would mix their seeds. The kernel
/// lets go when the process ends, however it does. What a killed one was writing is removed.
class FolderLock {
public:
    /// @throws raytracer::InputError where another process has it. A file system that knows no
    ///         locks is taken as it is.
    explicit FolderLock(const std::filesystem::path& folder);

private:
    FileDescriptor file_;
};

}  // namespace ticker::cli

#endif
