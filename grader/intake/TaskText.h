#ifndef TICKER_INTAKE_TASKTEXT_H
#define TICKER_INTAKE_TASKTEXT_H

#include <optional>
#include <string>
#include <string_view>

namespace ticker::intake {

/// The text between `// TASK <task> begin` and `// TASK <task> end`, without comments and white
/// space (string and character literals are unchanged); empty if the marks are missing.
[[nodiscard]] std::optional<std::string> taskText(std::string_view source, std::string_view task);

/// True if the stub is unchanged: both files have the task's marks and the same text between them.
[[nodiscard]] bool isStub(std::string_view source, std::string_view templateSource,
                          std::string_view task);

/// False if the source consists of a byte-order mark, white space and comments only. An
/// unterminated comment counts as code: the compiler reports it.
[[nodiscard]] bool holdsCode(std::string_view source);

}  // namespace ticker::intake

#endif
