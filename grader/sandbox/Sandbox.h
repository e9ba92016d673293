#ifndef TICKER_SANDBOX_SANDBOX_H
#define TICKER_SANDBOX_SANDBOX_H

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ticker::sandbox {

/// How well a command is locked in; docs/security.md says what each promises.
enum class Level {
    namespaces,  ///< A: bubblewrap, seccomp, limits
    ownUser,     ///< B: no user namespaces, but root: own uid, Landlock, seccomp, limits
    sameUser,    ///< C: an ordinary user without namespaces: Landlock, seccomp, limits
    none         ///< limits only; must be asked for by name
};

/// "A", "B", "C" or "none".
[[nodiscard]] std::string toString(Level level);

/// What a command may use up. The wall clock is watched from outside.
struct Limits {
    double cpuSeconds = 10.0;
    double wallSeconds = 30.0;
    std::uint64_t addressSpaceBytes = 1'500'000'000;
    std::uint64_t fileSizeBytes = 64U << 20U;
    std::uint64_t stackBytes = 64U << 20U;
    int processes = 256;  ///< and threads
    int openFiles = 64;
    std::size_t outputBytes =
        64U << 10U;  ///< of stdout and stderr together; more kills the command
};

/// Which system calls are let through.
enum class Policy {
    compile,  ///< a compiler and a linker: files below the given folders, child processes
    run       ///< a static program: no open, no process, no socket; threads are fine
};

/// A file or folder of the host that the command may read.
struct ReadOnlyPath {
    std::filesystem::path host;
    std::filesystem::path inside;  ///< where the command sees it (level A; the same path otherwise)
};

/// A descriptor handed to the command; all others are closed.
struct Descriptor {
    int host = -1;
    int inside = -1;  ///< 3 to 31
};

/// A regular file that the command leaves in its scratch folder. After the command has ended with
/// 0 and nothing of it runs any more, the file is copied to `host`, which the command never holds.
struct Product {
    std::string name;  ///< in the scratch folder; no path
    int host = -1;
};

/// The scratch folder, as `folder` names it at every level. Relative paths from there, and the
/// environment's TMPDIR, work at every level; "/tmp/x" in an argument works at level A only.
inline constexpr const char* kScratchFolder = "/tmp";

/// So many files of `Limits::fileSizeBytes` a scratch folder may hold. Level A enforces it; the
/// others keep as much room on their disk free for each job before it starts.
inline constexpr std::uint64_t kScratchFiles = 4;

/// One command to run.
struct Command {
    std::vector<std::string> arguments;  ///< argv; [0] is a path inside; see Sandbox::pathFor
    std::filesystem::path folder = "/";  ///< working directory, inside
    std::vector<ReadOnlyPath> readOnly;
    bool wantsScratch = false;  ///< an empty writable /tmp for `kScratchFiles` files of full size
    std::vector<Descriptor> descriptors;
    std::vector<Product> products;  ///< at most 16; needs `wantsScratch`
    Policy policy = Policy::run;
    Limits limits;
};

/// How a command ended, as the kernel says it; nothing in it is the command's own claim but
/// `output`.
struct Outcome {
    enum class End {
        exited,       ///< `code` is the exit status; 126 also: the file is no program
        signalled,    ///< `code` is the signal; SIGXCPU: the CPU limit, SIGSYS: a forbidden call
        wallLimit,    ///< killed by us: wall clock
        outputLimit,  ///< killed by us: too much output
        failed        ///< could not be started or watched: our fault; `output` says why
    };
    End end = End::failed;
    int code = 0;
    bool productsMissing = false;  ///< exited with 0, but did not leave what was to be copied
    std::string output;  ///< stdout and stderr as they came, cut at the limit; never trusted
    double cpuMs = 0.0;
    double wallMs = 0.0;
    std::uint64_t peakMemoryBytes = 0;

    [[nodiscard]] bool succeeded() const { return end == End::exited && code == 0; }
};

/// Runs commands that must not reach anything. May be shared by threads.
class Sandbox {
public:
    /// The best level that this machine gives.
    /// @throws raytracer::Error (notGradable) where it gives none but `Level::none`.
    [[nodiscard]] static Sandbox best();
    /// @throws raytracer::Error (notGradable) saying why, where this machine does not give `level`.
    [[nodiscard]] static Sandbox at(Level level);

    [[nodiscard]] Level level() const { return level_; }

    /// A new empty folder for files that commands are to read, until this process ends; the caller
    /// may remove it earlier. Everything in it must be readable by everybody (folders 0755, files
    /// 0644, programs 0755): where we are root, commands run as another user, who cannot reach
    /// what lies under a folder such as /root (mode 0700). So every `ReadOnlyPath::host` should be
    /// a system folder such as /usr or lie in such a folder. Strangers cannot list its parent and
    /// do not know its name.
    [[nodiscard]] static std::filesystem::path makeStagingFolder();

    /// Where a command of this sandbox sees `path`: for its arguments. `Command::folder` and
    /// `arguments[0]` are translated by `run`.
    [[nodiscard]] std::filesystem::path pathFor(const ReadOnlyPath& path) const;

    /// Runs the command to its end or to its limits. Nothing of it is left afterwards.
    /// Never throws for what the command does.
    [[nodiscard]] Outcome run(const Command& command) const;

private:
    explicit Sandbox(Level level) : level_(level) {}
    Level level_;
};

}  // namespace ticker::sandbox

#endif
