#ifndef TICKER_BUILD_PROGRAM_H
#define TICKER_BUILD_PROGRAM_H

#include <grader/sandbox/JobFolder.h>

#include <cstdint>
#include <filesystem>
#include <utility>

namespace ticker::build {

/// A submission's probe program on disk, removed on destruction.
class Program {
public:
    /// @param folder  Contains only the program, as "probe".
    explicit Program(sandbox::JobFolder folder) : folder_(std::move(folder)) {}

    [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "probe"; }

    /// Memory that the program needs before main, mostly for global variables, as its ELF file
    /// states. The kernel does not start a program whose limit is lower. 0 if the file does not
    /// say.
    [[nodiscard]] std::uint64_t staticBytes() const;

private:
    sandbox::JobFolder folder_;
};

}  // namespace ticker::build

#endif
