#ifndef TICKER_TESTS_FUZZ_FUZZ_H
#define TICKER_TESTS_FUZZ_FUZZ_H

#include <string>
#include <string_view>
#include <vector>

namespace ticker::fuzz {

/// Passes one input to the reader or judge under test. True: accepted; false: refused as specified.
/// Everything else, a crash or another exception, is a bug.
[[nodiscard]] bool give(std::string_view input);

/// Initial inputs: most of them valid.
[[nodiscard]] std::vector<std::string> seeds();

/// Throws std::logic_error, which no reader does, if a promise is broken.
void require(bool kept, const char* promise);

}  // namespace ticker::fuzz

#endif
