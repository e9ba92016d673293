#ifndef TICKER_INTAKE_SAFENAME_H
#define TICKER_INTAKE_SAFENAME_H

#include <set>
#include <string>

namespace ticker::intake {

/// A name for a folder that is valid on Linux and macOS file systems, does not collide with OUT's
/// own files, and is displayed harmlessly by shells and pages.
[[nodiscard]] std::string safeName(const std::string& wanted);

/// The name, with a number appended if it is taken; adds the result to `taken`.
[[nodiscard]] std::string uniqueName(const std::string& name, std::set<std::string>& taken);

}  // namespace ticker::intake

#endif
