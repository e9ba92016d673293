#ifndef TICKER_LAB_COVERAGE_PUBLICEXAMINER_H
#define TICKER_LAB_COVERAGE_PUBLICEXAMINER_H

#include <grader/lab/coverage/PublicCase.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::coverage {

/// Result of the public tests for one case.
struct Outcome {
    enum class Kind { ran, doesNotCompile, crashed, notAttempted } kind = Kind::ran;
    std::vector<std::string> failed;  ///< names of the task's failed tests

    [[nodiscard]] bool objects() const { return kind != Kind::ran || !failed.empty(); }
};

/// A temporary folder, removed with this object.
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

/// Runs the public tests on solutions.
class Examiner {
public:
    /// Compiles the reference solution, which replaces missing files of a case.
    /// @param root      The project's root.
    /// @throws raytracer::Error if our own files fail.
    Examiner(std::filesystem::path root, const Exercise& exercise);

    /// Compiles a case, links it with the public tests and runs them. Threads may share an
    /// examiner.
    /// @throws raytracer::Error if our own files fail.
    [[nodiscard]] Outcome examine(const Case& one) const;

private:
    [[nodiscard]] bool compile(const std::string& text, const std::string& name,
                               const std::filesystem::path& folder) const;
    [[nodiscard]] bool build(const Case& one, const std::filesystem::path& folder) const;

    std::filesystem::path root_;
    const Exercise& exercise_;
    std::map<std::string, std::string> suites_;  ///< of the public tests, by task
    ScratchFolder reference_;
};

}  // namespace ticker::coverage

#endif
