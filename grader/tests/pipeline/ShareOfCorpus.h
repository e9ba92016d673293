#ifndef TICKER_TESTS_PIPELINE_SHAREOFCORPUS_H
#define TICKER_TESTS_PIPELINE_SHAREOFCORPUS_H

#include <grader/corpus/Entry.h>
#include <grader/tests/support/SlowRun.h>

#include <string>
#include <vector>

namespace ticker::tests {

/// Every third entry of a collection; all of them by `./tick guard slow`. `./tick demo`, which a
/// test of the documents runs, holds all samples to their verdicts.
[[nodiscard]] inline std::vector<corpus::Entry> shareOf(const std::string& collection) {
    const std::vector<corpus::Entry> all = corpus::readEntries(TICKER_SOURCE_DIR, {collection});
    std::vector<corpus::Entry> share;
    for (std::size_t i = 0; i < all.size(); i += isSlowRun() ? 1 : 3)
        share.push_back(all[i]);
    return share;
}

}  // namespace ticker::tests

#endif
