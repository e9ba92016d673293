#ifndef TICKER_BUILD_KIT_H
#define TICKER_BUILD_KIT_H

#include <grader/exercise/Exercise.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::build {

/// Everything that submissions to an exercise are compiled and linked with, prebuilt in one folder
/// (grader/build/kit).
class Kit {
public:
    /// The kit of the installation or build tree that the running program belongs to:
    /// ../lib/ticker/kit/EXERCISE or ../kit/EXERCISE from its folder.
    /// @throws raytracer::Error (notGradable) if it is missing or incomplete.
    [[nodiscard]] static Kit besideProgram(const Exercise& exercise = defaultExercise());
    /// @throws raytracer::Error (notGradable) if `folder` holds no kit.
    [[nodiscard]] static Kit at(const std::filesystem::path& folder);

    /// Readable by every user; a copy if the kit, or its folder, is private.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] const std::string& compiler() const { return compiler_; }
    [[nodiscard]] const std::vector<std::string>& compileFlags() const { return compileFlags_; }
    /// The same without optimisation, for a program that is asked once.
    [[nodiscard]] const std::vector<std::string>& quickFlags() const { return quickFlags_; }
    [[nodiscard]] const std::vector<std::string>& linkFlags() const { return linkFlags_; }

    /// The framework's headers, precompiled for Clang's parser. Empty if the kit has none, or was
    /// moved since: the file names its place.
    [[nodiscard]] std::filesystem::path parsedHeader() const;

    /// Names of the files that a submission may contain.
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }
    /// Source of one of these files as students received it.
    [[nodiscard]] std::string templateSource(const std::string& file) const;
    /// The compiled form of it; the path is relative to the kit's folder.
    [[nodiscard]] static std::string templateObject(const std::string& file);

private:
    Kit() = default;

    std::filesystem::path folder_;
    std::filesystem::path madeAt_;
    std::string compiler_;
    std::vector<std::string> compileFlags_;
    std::vector<std::string> quickFlags_;
    std::vector<std::string> linkFlags_;
    std::vector<std::string> files_;
};

}  // namespace ticker::build

#endif
