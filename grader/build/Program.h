#ifndef TICKER_BUILD_PROGRAM_H
#define TICKER_BUILD_PROGRAM_H

#include <cstdint>
#include <filesystem>
#include <utility>

namespace ticker::build {

/// An empty folder that every user can read, removed with all that is in it at the end.
class JobFolder {
public:
    /// @throws raytracer::Error (notGradable) where none can be made.
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

/// A submission's probe program on disk, until the end of this object.
class Program {
public:
    /// @param folder  Holds the program alone, as "probe".
    explicit Program(JobFolder folder) : folder_(std::move(folder)) {}

    [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "probe"; }

    /// Memory that it takes before it does anything, mostly for global variables, as its file says:
    /// the kernel starts no program that has less. 0 where the file says nothing.
    [[nodiscard]] std::uint64_t staticBytes() const;

private:
    JobFolder folder_;
};

}  // namespace ticker::build

#endif
