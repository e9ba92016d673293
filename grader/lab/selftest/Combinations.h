#ifndef TICKER_SELFTEST_COMBINATIONS_H
#define TICKER_SELFTEST_COMBINATIONS_H

#include <grader/corpus/Entry.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ticker::selftest {

/// Right submissions that make several accepted choices at once. Two readings that pass alone may
/// fail together, where a check allows for one of them at a time.
/// @param accepted  Entries that must pass. Those with a review, with files of their own or with a
///                  reason to be alone are left out.
/// @return  Up to `count` combinations of two to four entries whose edits apply one after the
///          other, each once: all tasks pass, with whatever warnings. Fewer if few fit together.
/// @throws raytracer::Error if a file of the base cannot be read.
[[nodiscard]] std::vector<corpus::Entry> drawCombinations(std::vector<corpus::Entry> accepted,
                                                          std::size_t count, std::uint64_t seed);

}  // namespace ticker::selftest

#endif
