#ifndef TICKER_SANDBOX_SANDBOX_H
#define TICKER_SANDBOX_SANDBOX_H

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ticker::sandbox {

/// How strongly a command is confined; docs/security.md says what each level promises.
enum class Level {
    namespaces,  ///< A: bubblewrap (namespaces), seccomp, limits
    ownUser,     ///< B: root without user namespaces: a uid of its own, Landlock, seccomp, limits
    sameUser,    ///< C: an ordinary user without namespaces: Landlock, seccomp, limits
    none         ///< limits only; must be requested explicitly
};

/// "A", "B", "C" or "none".
[[nodiscard]] std::string toString(Level level);

/// Resource limits of a command. The wall clock is measured from outside.
struct Limits {
    double cpuSeconds = 10.0;
    double wallSeconds = 30.0;
    std::uint64_t addressSpaceBytes = 1'500'000'000;
    std::uint64_t fileSizeBytes = 64U << 20U;
    std::uint64_t stackBytes = 64U << 20U;
    int processes = 256;  ///< processes and threads together
    int openFiles = 64;
    std::size_t outputBytes =
        64U << 10U;  ///< of stdout and stderr together; beyond it the command is killed
};

/// Which system calls are allowed.
enum class Policy {
    compile,  ///< a compiler and a linker: files below the given folders, child processes
    run       ///< a static program: no open, no process, no socket; threads are fine
};

/// A file or folder of the host that the command may read.
struct ReadOnlyPath {
    std::filesystem::path host;
    std::filesystem::path inside;  ///< where the command sees it (level A; the same path otherwise)
};

/// A descriptor passed to the command; all others are closed.
struct Descriptor {
    int host = -1;
    int inside = -1;  ///< 3 to 31
};

/// A regular file that the command leaves in its scratch folder. After the command has exited with
/// status 0 and all its processes have ended, the file is copied to `host`, which the command never
/// holds.
struct Product {
    std::string name;  ///< a file name in the scratch folder, without a path
    int host = -1;
};

/// The scratch folder, as `folder` names it at every level. Relative paths from there and the
/// variable TMPDIR work at every level; "/tmp/x" in an argument works at level A only.
inline constexpr const char* kScratchFolder = "/tmp";

/// Size of a scratch folder, in files of `Limits::fileSizeBytes`. Level A enforces it; the other
/// levels reserve that much disk space for each job before it starts.
inline constexpr std::uint64_t kScratchFiles = 4;

/// One command to run.
struct Command {
    std::vector<std::string>
        arguments;  ///< argv; [0] is a path inside of the jail; see Sandbox::pathFor
    std::filesystem::path folder = "/";  ///< working directory, inside of the jail
    std::vector<ReadOnlyPath> readOnly;
    bool wantsScratch =
        false;  ///< an empty writable /tmp that holds `kScratchFiles` files of full size
    std::vector<Descriptor> descriptors;
    std::vector<Product> products;  ///< at most 16; needs `wantsScratch`
    Policy policy = Policy::run;
    Limits limits;
};

/// Exit status of a command that exists but cannot be executed: the same as a shell's. A command
/// can also leave with it by itself.
inline constexpr int kNotExecutable = 126;

/// How a command ended, as reported by the kernel. Only `output` is controlled by the command.
struct Outcome {
    enum class End {
        exited,       ///< `code` is the exit status; see kNotExecutable
        signalled,    ///< `code` is the signal; SIGXCPU: the CPU limit, SIGSYS: a forbidden call,
                      ///< SIGKILL: want of memory, or (Level::none) anything
        wallLimit,    ///< killed by the sandbox: wall clock
        outputLimit,  ///< killed by the sandbox: too much output
        failed  ///< could not be started or watched, or was killed from outside of the jail: an
                ///< error of the grader; `output` says why
    };
    End end = End::failed;
    int code = 0;
    bool productsMissing = false;  ///< exited with 0 but left a product out
    std::string output;            ///< stdout and stderr as printed, cut at the limit; untrusted
    double cpuMs = 0.0;
    double wallMs = 0.0;
    std::uint64_t peakMemoryBytes = 0;
    /// The kernel ended some process of this machine for want of memory meanwhile. Looked at for
    /// Policy::compile only: a compiler's driver outlives the compiler.
    bool machineRanOut = false;

    [[nodiscard]] bool succeeded() const { return end == End::exited && code == 0; }
};

/// True if the command used so little of its memory that it was not what filled the machine.
[[nodiscard]] inline bool usedLittleMemory(const Outcome& outcome, const Limits& limits,
                                           Policy policy) {
    // By default a compiler takes a sixth of its limit for a right file, and a right program a
    // thirtieth. A machine without that much memory fails right submissions, too, so a
    // program gains nothing by filling it.
    const std::uint64_t share = policy == Policy::compile ? 4 : 8;
    return outcome.peakMemoryBytes < limits.addressSpaceBytes / share;
}

/// Runs untrusted commands. Safe to share between threads.
class Sandbox {
public:
    /// The best level that this machine offers.
    /// @throws raytracer::Error (notGradable) if it offers only `Level::none`.
    [[nodiscard]] static Sandbox best();
    /// @throws raytracer::Error (notGradable) with the reason if this machine does not offer
    ///         `level`.
    [[nodiscard]] static Sandbox at(Level level);

    [[nodiscard]] Level level() const { return level_; }

    /// Makes an empty folder for files that commands read. It exists until this process ends or the
    /// caller removes it. Everything in it must be readable by all users (folders 0755, files 0644,
    /// programs 0755): as root, commands run under another uid, which cannot reach files below a
    /// folder such as /root (mode 0700). So every `ReadOnlyPath::host` should be a system folder
    /// such as /usr, or lie in a folder made here. Other users cannot list its parent and do not
    /// know its name.
    [[nodiscard]] static std::filesystem::path makeStagingFolder();

    /// Where a command of this sandbox sees `path`: for use in its arguments. `run` translates
    /// `Command::folder` and `arguments[0]` itself.
    [[nodiscard]] std::filesystem::path pathFor(const ReadOnlyPath& path) const;

    /// Runs the command until it ends or reaches a limit. None of its processes is left afterwards.
    /// Never throws because of what the command does.
    [[nodiscard]] Outcome run(const Command& command) const;

private:
    explicit Sandbox(Level level) : level_(level) {}
    Level level_;
};

}  // namespace ticker::sandbox

#endif
