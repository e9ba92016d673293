#include <grader/package/StudentPackage.h>
#include <grader/tests/student/UnpackedPackage.h>
#include <grader/tests/support/CompilerCache.h>

#include <stdexcept>

namespace ticker::tests {

namespace fs = std::filesystem;

UnpackedPackage::UnpackedPackage(const Exercise& exercise) : name_(exercise.name) {
    package::writeStudentPackage(TICKER_SOURCE_DIR, exercise, work_.path() / "package.zip");
    const CommandResult unpacked =
        runCommand("cd '" + work_.path().string() + "' && cmake -E tar xf package.zip");
    if (unpacked.status != 0) throw std::runtime_error("cannot unpack: " + unpacked.output);
}

fs::path UnpackedPackage::folder() const {
    return work_.path() / name_;
}

std::vector<fs::path> UnpackedPackage::files() const {
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder()})
        if (entry.is_regular_file()) found.push_back(entry.path());
    return found;
}

CommandResult UnpackedPackage::runAlone(const std::string& command) const {
    return runCommand(
        "bwrap --unshare-all --die-with-parent --clearenv --setenv PATH /usr/bin:/bin --setenv "
        "HOME "
        "/tmp --ro-bind /usr /usr --symlink usr/lib /lib --symlink usr/lib64 /lib64 --symlink "
        "usr/bin /bin --ro-bind /etc/alternatives /etc/alternatives --proc /proc --dev /dev "
        "--tmpfs "
        "/tmp " +
        compilerCacheFor("/ccache") + "--bind '" + folder().string() +
        "' /student --chdir /student bash -c '" + command + "'");
}

}  // namespace ticker::tests
