#ifndef TICKER_SANDBOX_JOBFOLDER_H
#define TICKER_SANDBOX_JOBFOLDER_H

#include <filesystem>
#include <string>
#include <string_view>

namespace ticker::sandbox {

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

    /// Writes a file in it that every user can read.
    /// @throws raytracer::Error (notGradable) if it cannot be written, as on a full disk.
    void write(const std::string& name, std::string_view bytes) const;

private:
    std::filesystem::path path_;
};

}  // namespace ticker::sandbox

#endif
