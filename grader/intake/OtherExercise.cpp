#include <grader/intake/OtherExercise.h>

#include <grader/intake/TaskText.h>
#include <grader/result/GeneralFindings.h>

#include <fmt/core.h>

#include <algorithm>

namespace ticker::intake {
namespace {

bool hasMarks(std::string_view source, const Exercise& exercise) {
    return std::ranges::any_of(exercise.tasks, [&](const TaskEntry& task) {
        return taskText(source, task.id).has_value();
    });
}

bool isFileOf(const std::string& name, const Exercise& exercise) {
    return name != kScreenshotPart && std::ranges::count(exercise.files(), name) > 0;
}

/// Where both exercises have a file of this name, its marks decide.
bool isOf(const Candidate& candidate, const Exercise& exercise, const Exercise& other) {
    return isFileOf(candidate.part, exercise) &&
           (!isFileOf(candidate.part, other) || hasMarks(candidate.bytes, exercise));
}

bool belongsTo(const Contents& contents, const Exercise& other, const Exercise& wanted) {
    const auto isWanted = [&](const Candidate& each) { return isOf(each, wanted, other); };
    if (std::ranges::any_of(contents.candidates, isWanted)) return false;
    const auto isOther = [&](const Candidate& each) { return isOf(each, other, wanted); };
    return std::ranges::any_of(contents.candidates, isOther) ||
           std::ranges::any_of(contents.others, [&](const std::string& path) {
               const auto part = partOf(path, other);
               return part && isFileOf(*part, other) && !isFileOf(*part, wanted);
           });
}

}  // namespace

const Exercise* otherExercise(const Contents& contents, const Exercise& wanted,
                              std::span<const Exercise> others) {
    for (const Exercise& other : others)
        if (other.name != wanted.name && belongsTo(contents, other, wanted)) return &other;
    return nullptr;
}

Finding belongsElsewhere(const Exercise& other, const Exercise& wanted) {
    return refusal(
        kIntakeMissingFile, fmt::format("These are files of another exercise, {}.", other.title),
        fmt::format("Hand in {} of {}.", enumerated(wanted.files(), "or"), wanted.title));
}

}  // namespace ticker::intake
