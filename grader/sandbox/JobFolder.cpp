#include <grader/sandbox/JobFolder.h>
#include <grader/sandbox/Sandbox.h>

#include <raytracer/base/Error.h>

#include <fstream>
#include <system_error>
#include <utility>

namespace ticker::sandbox {

JobFolder::JobFolder() : path_(Sandbox::makeStagingFolder()) {}

JobFolder::~JobFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

JobFolder::JobFolder(JobFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}

JobFolder& JobFolder::operator=(JobFolder&& other) noexcept {
    std::swap(path_, other.path_);
    return *this;
}

void JobFolder::write(const std::string& name, std::string_view bytes) const {
    const std::filesystem::path file = path_ / name;
    std::ofstream stream{file, std::ios::binary};
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    std::error_code error;
    if (stream) std::filesystem::permissions(file, std::filesystem::perms{0644}, error);
    if (!stream || error)
        throw raytracer::Error("cannot write " + file.string() +
                               "; is the disk full? TMPDIR names another one");
}

}  // namespace ticker::sandbox
