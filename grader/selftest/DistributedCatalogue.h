#ifndef TICKER_SELFTEST_DISTRIBUTEDCATALOGUE_H
#define TICKER_SELFTEST_DISTRIBUTEDCATALOGUE_H

#include <grader/build/Kit.h>
#include <grader/decision/TaskJudgement.h>
#include <grader/mistakes/Catalogue.h>
#include <grader/sandbox/Sandbox.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ticker::selftest {

/// How much of the catalogue to run, and how.
struct CatalogueRun {
    double fraction = 1.0;   ///< share of the entries, evenly picked; at least one
    std::uint64_t seed = 1;  ///< of the decisions, and of which entries are picked
    int decisions = 1;       ///< for each entry, seeds seed, seed + 1, ...
    int jobs = 2;
    std::function<void(std::size_t done, std::size_t of)>
        progress;  ///< one call at a time; or null
};

/// What became of one entry.
struct CatalogueRow {
    mistakes::Mistake entry;
    std::string seen;         ///< "failed shadow.hard", of the first decision that differed, if any
    bool asExpected = false;  ///< in every decision, and the other task passed
    double cpuMs = 0.0;       ///< of the submission's process for one decision, the largest seen
};

/// Makes the mistakes and the accepted readings of T2.1 and T2.2 in `reference` (Renderer.cpp of
/// the reference solution), compiles each and judges it.
/// @throws raytracer::Error where an edit does not fit or something does not compile.
[[nodiscard]] std::vector<CatalogueRow> runDistributedCatalogue(
    const std::vector<mistakes::Mistake>& catalogue, const std::string& reference,
    const build::Kit& kit, const sandbox::Sandbox& sandbox, const CatalogueRun& run);

/// One line for each row, those that differ marked, and a summary.
[[nodiscard]] std::string tableOf(const std::vector<CatalogueRow>& rows);

}  // namespace ticker::selftest

#endif
