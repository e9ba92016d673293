#ifndef TICKER_SIMILAR_PLAINLINES_H
#define TICKER_SIMILAR_PLAINLINES_H

#include <string>
#include <string_view>
#include <vector>

namespace ticker::similar {

/// What the matcher is given, whose scanner stumbles over what a student may write: ASCII without
/// comments, with "" or '0' for a literal. Code stays in its line; spliced lines are joined up to
/// their first space.
[[nodiscard]] std::vector<std::string> plainLines(std::string_view source);

}  // namespace ticker::similar

#endif
