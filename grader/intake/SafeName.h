#ifndef TICKER_INTAKE_SAFENAME_H
#define TICKER_INTAKE_SAFENAME_H

#include <set>
#include <string>

namespace ticker::intake {

/// A folder of this name can be made on any system, also among the files that OUT itself holds, and
/// a shell or a page shows it without surprise.
[[nodiscard]] std::string safeName(const std::string& wanted);

/// The name, or the name with a number; takes what it gives.
[[nodiscard]] std::string uniqueName(const std::string& name, std::set<std::string>& taken);

}  // namespace ticker::intake

#endif
