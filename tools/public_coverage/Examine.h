#ifndef TICKER_TOOLS_PUBLICCOVERAGE_EXAMINE_H
#define TICKER_TOOLS_PUBLICCOVERAGE_EXAMINE_H

#include "Case.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::coverage {

/// What the public tests say about one case.
struct Outcome {
    enum class Kind { ran, doesNotCompile, crashed, notAttempted } kind = Kind::ran;
    std::vector<std::string> failed;  ///< names of the task's tests

    [[nodiscard]] bool objects() const { return kind != Kind::ran || !failed.empty(); }
};

/// A folder that goes away with its owner.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Runs the public tests over solutions.
class Examiner {
public:
    /// Compiles the reference solution, for what a case leaves out.
    /// @param root      The project's.
    /// @param linkFile  What to link with: the compiler's @FILE.
    /// @throws raytracer::Error where our own side fails.
    Examiner(std::filesystem::path root, std::filesystem::path linkFile);

    /// Compiles a case, links it with the public tests and runs them. Threads may share an
    /// examiner.
    /// @throws raytracer::Error where our own side fails.
    [[nodiscard]] Outcome examine(const Case& one) const;

private:
    [[nodiscard]] bool compile(const std::string& text, const std::string& name,
                               const std::filesystem::path& folder) const;
    [[nodiscard]] bool build(const Case& one, const std::filesystem::path& folder) const;

    std::filesystem::path root_;
    std::filesystem::path linkFile_;
    ScratchFolder reference_;
};

}  // namespace ticker::coverage

#endif
