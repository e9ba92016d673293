#ifndef TICKER_CALIBRATE_SUBJECT_H
#define TICKER_CALIBRATE_SUBJECT_H

#include <grader/build/Kit.h>
#include <grader/build/Program.h>
#include <grader/corpus/Entry.h>
#include <grader/exercise/Exercise.h>
#include <grader/sandbox/Sandbox.h>

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::calibrate {

/// A file to be judged, and the expected result.
struct Subject {
    std::string name;  ///< "T2.1/light-size-0.36"
    std::string source;
    std::string task;  ///< the task of `expect`; empty: all tasks of the file must pass
    corpus::Expectation expect;
    std::string file;  ///< its name
    const Exercise* exercise = &defaultExercise();

    [[nodiscard]] bool isRight() const { return expect.passes(); }
    /// The task that it is about; the file's first task if it is about all of them.
    [[nodiscard]] std::string ownTask() const;
    /// The text that its verdict depends on: its code without comments, and the expected result.
    [[nodiscard]] std::string basis() const;
    /// Its rays are not visible, so that values or pictures are judged.
    [[nodiscard]] bool isUnseen() const;
    /// Only a distribution is wrong, so that statistics must find it.
    [[nodiscard]] bool isStatistical() const;
    /// A data race: threads share a variable that each needs for itself. In some runs it has no
    /// effect.
    [[nodiscard]] bool isDataRace() const;
};

/// Subjects that campaigns repeat or look at more closely; all draw from the kit's generator alone.
inline constexpr std::array<std::string_view, 4> kQuick{
    "T2.1/accepted-per-sample", "T2.1/light-size-0.36", "T2.2/accepted-stratified",
    "T2.2/aperture-size-0.9"};
inline constexpr std::array<std::string_view, 4> kQuickExact{
    "tick1star:T1/inverted-u", "tick1:M2/view-reversed", "tick1:M3.1/absolute",
    "tick1:M3.2/at-least"};
inline constexpr std::array<std::string_view, 2> kRightAndSmaller{"T2.1/accepted-per-sample",
                                                                  "T2.1/light-size-0.36"};
inline constexpr std::array<std::string_view, 2> kRightAndHard{"T2.1/accepted-per-sample",
                                                               "T2.1/hard-centre"};
/// Right ones that get `dof.antialiased`, `shadow.view-from-eye` or `shadow.near-side-falloff`,
/// which explains their pictures, though no expectation names it.
inline constexpr std::array<std::string_view, 2> kOtherPictures{
    "right/antialiased-pixels", "T2.1/accepted-own-intersection-per-sample-eye"};
/// Mistakes that a doubt about pictures must find every time, and those where it is only measured.
inline constexpr std::array<std::string_view, 2> kSeenInPictures{"T2.1/hard-centre", "T2.2/none"};
inline constexpr std::array<std::string_view, 8> kMeasuredInPictures{
    "T2.1/light-size-0.3",    "T2.1/light-size-0.5",    "T2.1/light-size-0.8",
    "T2.2/aperture-size-0.7", "T2.2/aperture-size-1.4", "T2.2/disc",
    "T2.2/focal-plane-0.9",   "T2.2/off-centre-quarter"};

[[nodiscard]] bool isAmong(std::span<const std::string_view> names, const Subject& subject);

/// The scene with random rays that is handed in; its file is that of the subjects.
[[nodiscard]] const SceneEntry& randomScene();

/// The catalogue's entries about that file's tasks applied to the reference, and the right
/// solutions of grader/corpus/unseen and grader/corpus/samples.
/// @param data  The data folder, `Home::data`.
/// @throws raytracer::InputError if one cannot be read.
[[nodiscard]] std::vector<Subject> readSubjects(const std::filesystem::path& data);

/// The same for all other files of all exercises: the verdicts on their tasks are exact.
[[nodiscard]] std::vector<Subject> readExactSubjects(const std::filesystem::path& data);

/// Compiles each subject once, on first use. Threads may share it.
class Programs {
public:
    /// @throws raytracer::Error (notGradable) if the kit of an exercise is missing.
    explicit Programs(const sandbox::Sandbox& sandbox);

    /// The program lives as long as this object.
    /// @throws raytracer::Error if the subject does not compile.
    [[nodiscard]] const build::Program& of(const Subject& subject);

    [[nodiscard]] const build::Kit& kit(const Exercise& exercise = defaultExercise()) const {
        return kits_.at(exercise.name);
    }
    [[nodiscard]] const sandbox::Sandbox& sandbox() const { return sandbox_; }

private:
    struct Slot {
        std::once_flag once;
        std::unique_ptr<build::Program> program;
    };
    std::map<std::string, build::Kit> kits_;  // by exercise
    const sandbox::Sandbox& sandbox_;
    std::mutex mutex_;
    std::map<std::string, Slot> slots_;
};

}  // namespace ticker::calibrate

#endif
