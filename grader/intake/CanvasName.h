#ifndef TICKER_INTAKE_CANVASNAME_H
#define TICKER_INTAKE_CANVASNAME_H

#include <optional>
#include <string>
#include <string_view>

namespace ticker::intake {

/// The parts of a file name in Canvas's "Download Submissions":
/// leeann_late_4711_90210_work.cpp.
struct CanvasName {
    std::string owner;  ///< "leeann_4711": the name without spaces, and the user's id
    std::string file;   ///< "work.cpp", or "work-1.cpp" after a second attempt
};

/// Empty if the name follows another pattern. Attachments of Canvas have large ids, so that names
/// with years or numbers of groups do not count.
[[nodiscard]] std::optional<CanvasName> readCanvasName(std::string_view name);

}  // namespace ticker::intake

#endif
