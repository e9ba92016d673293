#ifndef TICKER_CALIBRATE_SUBJECT_H
#define TICKER_CALIBRATE_SUBJECT_H

#include <grader/build/Kit.h>
#include <grader/build/Program.h>
#include <grader/corpus/Entry.h>
#include <grader/sandbox/Sandbox.h>

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace ticker::calibrate {

/// A file to be judged, and the expected result.
struct Subject {
    std::string name;  ///< "T2.1/light-size-0.36"
    std::string source;
    std::string task;  ///< the task of `expect`; empty: both tasks must pass
    corpus::Expectation expect;

    [[nodiscard]] bool isRight() const { return expect.passes(); }
    /// Its rays are not visible, so that values or pictures are judged.
    [[nodiscard]] bool isUnseen() const;
    /// Only a distribution is wrong, so that statistics must find it.
    [[nodiscard]] bool isStatistical() const;
};

/// The catalogue's entries of T2.1 and T2.2 applied to the reference, and the right solutions of
/// grader/corpus/unseen/T2 and grader/corpus/samples.
/// @param data  The kit's folder, see cli/Home.h.
/// @throws raytracer::InputError if one cannot be read.
[[nodiscard]] std::vector<Subject> readSubjects(const std::filesystem::path& data);

/// Compiles each subject once, on first use. Threads may share it.
class Programs {
public:
    Programs(const build::Kit& kit, const sandbox::Sandbox& sandbox)
        : kit_(kit), sandbox_(sandbox) {}

    /// The program lives as long as this object.
    /// @throws raytracer::Error if the subject does not compile.
    [[nodiscard]] const build::Program& of(const Subject& subject);

    [[nodiscard]] const build::Kit& kit() const { return kit_; }
    [[nodiscard]] const sandbox::Sandbox& sandbox() const { return sandbox_; }

private:
    struct Slot {
        std::once_flag once;
        std::unique_ptr<build::Program> program;
    };
    const build::Kit& kit_;
    const sandbox::Sandbox& sandbox_;
    std::mutex mutex_;
    std::map<std::string, Slot> slots_;
};

}  // namespace ticker::calibrate

#endif
