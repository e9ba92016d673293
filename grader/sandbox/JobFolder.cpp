#include <grader/sandbox/JobFolder.h>
#include <grader/sandbox/Sandbox.h>

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

}  // namespace ticker::sandbox
