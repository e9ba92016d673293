#ifndef TICKER_INTAKE_TASKTEXT_H
#define TICKER_INTAKE_TASKTEXT_H

#include <optional>
#include <string>
#include <string_view>

namespace ticker::intake {

/// What stands between `// TASK <task> begin` and `// TASK <task> end`, without comments and white
/// space (string and character literals stay as they are); empty where the marks are missing.
[[nodiscard]] std::optional<std::string> taskText(std::string_view source, std::string_view task);

/// True where the stub still stands: both files have the task's marks and the same text between.
[[nodiscard]] bool isStub(std::string_view source, std::string_view templateSource,
                          std::string_view task);

/// False where there is nothing but a byte-order mark, white space and comments. A comment that
/// never ends counts as code: the compiler says where it begins.
[[nodiscard]] bool holdsCode(std::string_view source);

}  // namespace ticker::intake

#endif
