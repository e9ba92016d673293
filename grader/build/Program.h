#ifndef TICKER_BUILD_PROGRAM_H
#define TICKER_BUILD_PROGRAM_H

#include <cstdint>
#include <filesystem>
#include <utility>

namespace ticker::build {

/// An empty folder that every user can read; removed with all contents on destruction.
class JobFolder {
public:
    /// @throws raytracer::Error (notGradable) if no folder can be made.
    JobFolder();
    ~JobFolder();
    JobFolder(JobFolder&& other) noexcept;
    JobFolder& operator=(JobFolder&& other) noexcept;
    JobFolder(const JobFolder&) = delete;
    JobFolder& operator=(const JobFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// A submission's probe program on disk, removed on destruction.
class Program {
public:
    /// @param folder  Contains only the program, as "probe".
    explicit Program(JobFolder folder) : folder_(std::move(folder)) {}

    [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "probe"; }

    /// Memory that the program needs before main, mostly for global variables, as its ELF file
    /// states. The kernel does not start a program whose limit is lower. 0 if the file does not
    /// say.
    [[nodiscard]] std::uint64_t staticBytes() const;

private:
    JobFolder folder_;
};

}  // namespace ticker::build

#endif
