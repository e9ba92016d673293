#ifndef TICKER_TESTS_TASKS_SUPPORT_INFINDING_H
#define TICKER_TESTS_TASKS_SUPPORT_INFINDING_H

#include <grader/result/Finding.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

namespace ticker::tasks {

/// Empty without a finding.
inline std::string idOf(const std::optional<Finding>& finding) {
    return finding ? finding->id : std::string{};
}

/// A number among the evidence; throws std::out_of_range if the evidence has no such key.
inline double numberIn(const Finding& finding, const std::string& key) {
    for (const auto& [name, value] : finding.evidence)
        if (name == key) return std::get<double>(value);
    throw std::out_of_range(key);
}

}  // namespace ticker::tasks

#endif
