#ifndef TICKER_SELFTEST_TRACES_H
#define TICKER_SELFTEST_TRACES_H

#include <grader/sandbox/UserSlots.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace ticker::selftest {

/// A bait for hostile submissions, and the places where they would leave traces. Has a folder of
/// its own, which is removed with this object.
class Traces {
public:
    /// @throws raytracer::Error if the folder or the secret cannot be written.
    Traces();
    ~Traces();
    Traces(const Traces&) = delete;
    Traces& operator=(const Traces&) = delete;

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// A file that all users can read, but that lies in no jail.
    [[nodiscard]] std::filesystem::path secretFile() const { return folder_ / "secret.txt"; }
    /// A text that must not appear in any output.
    [[nodiscard]] const std::string& secret() const { return secret_; }

    /// True if the file exists that the corpus tries to write; removes it.
    [[nodiscard]] bool takeEscaped() const;

private:
    std::filesystem::path folder_;
    std::string secret_;
};

/// Processes with a jail's uid although no running jail has this uid; empty if we are not root.
[[nodiscard]] std::vector<std::string> processesLeft(const sandbox::UserRange& users);

/// True if this process has a child that is running, or has not been waited for yet.
[[nodiscard]] bool hasChildLeft();

/// Things that grading could leave behind, counted now.
struct Footprint {
    std::size_t processes = 0;  ///< of finished jails, and children of this process
    std::size_t files = 0;      ///< in the staging folder of jails
    std::size_t mounts = 0;     ///< visible to this process
    double residentMb = 0.0;    ///< memory of this process
    double sharedMb = 0.0;      ///< the machine's memory files and file systems in memory
    double availableMb = 0.0;   ///< of the machine, including other programs; for information
};
[[nodiscard]] Footprint footprint(const sandbox::UserRange& users);

/// Short descriptions of everything that increased: any process, file or mount, and memory beyond
/// 100 MB.
[[nodiscard]] std::vector<std::string> leftBehind(const Footprint& before, const Footprint& after);

}  // namespace ticker::selftest

#endif
