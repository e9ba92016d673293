#ifndef TICKER_RESULT_NAMES_H
#define TICKER_RESULT_NAMES_H

#include <grader/result/SubmissionResult.h>

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace ticker {

/// Names of enumeration values in result.json, in both directions.
inline constexpr std::array<std::pair<Severity, std::string_view>, 3> kSeverityNames{
    {{Severity::fail, "fail"}, {Severity::warn, "warn"}, {Severity::note, "note"}}};

inline constexpr std::array<std::pair<TaskState, std::string_view>, 5> kTaskStateNames{
    {{TaskState::passed, "passed"},
     {TaskState::failed, "failed"},
     {TaskState::notAttempted, "notAttempted"},
     {TaskState::blocked, "blocked"},
     {TaskState::notGraded, "notGraded"}}};

inline constexpr std::array<std::pair<Verdict, std::string_view>, 4> kVerdictNames{
    {{Verdict::awarded, "awarded"},
     {Verdict::notAwarded, "notAwarded"},
     {Verdict::needsReview, "needsReview"},
     {Verdict::notGraded, "notGraded"}}};

inline constexpr std::array<std::pair<ScatterPlot::Shape, std::string_view>, 2> kShapeNames{
    {{ScatterPlot::Shape::square, "square"}, {ScatterPlot::Shape::disc, "disc"}}};

template <typename Value, std::size_t size>
[[nodiscard]] constexpr std::string_view nameIn(
    const std::array<std::pair<Value, std::string_view>, size>& names, Value value) {
    for (const auto& [known, name] : names)
        if (known == value) return name;
    return "?";
}

/// Empty if no value has that name.
template <typename Value, std::size_t size>
[[nodiscard]] constexpr std::optional<Value> valueIn(
    const std::array<std::pair<Value, std::string_view>, size>& names, std::string_view wanted) {
    for (const auto& [value, name] : names)
        if (name == wanted) return value;
    return std::nullopt;
}

[[nodiscard]] constexpr std::string_view toString(Severity value) {
    return nameIn(kSeverityNames, value);
}
[[nodiscard]] constexpr std::string_view toString(TaskState value) {
    return nameIn(kTaskStateNames, value);
}
[[nodiscard]] constexpr std::string_view toString(Verdict value) {
    return nameIn(kVerdictNames, value);
}
[[nodiscard]] constexpr std::string_view toString(ScatterPlot::Shape value) {
    return nameIn(kShapeNames, value);
}

}  // namespace ticker

#endif
