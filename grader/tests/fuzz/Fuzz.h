#ifndef TICKER_TESTS_FUZZ_FUZZ_H
#define TICKER_TESTS_FUZZ_FUZZ_H

#include <string>
#include <string_view>
#include <vector>

namespace ticker::fuzz {

/// Gives one input to the reader under test. True: it was taken; false: it was refused as it should
/// be. Whatever else happens, a crash or another exception, is a find.
[[nodiscard]] bool give(std::string_view input);

/// Inputs to begin with: most of them good.
[[nodiscard]] std::vector<std::string> seeds();

/// Throws std::logic_error, which no reader does, where a promise was not kept.
void require(bool kept, const char* promise);

}  // namespace ticker::fuzz

#endif
