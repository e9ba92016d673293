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

/// What became of one entry, over all of its decisions.
struct CatalogueRow {
    mistakes::Mistake entry;
    int decisions = 0;
    int wrongState = 0;       ///< passed what must fail, or failed what must pass
    int wrongName = 0;        ///< the state is right, the first finding another one
    int otherTask = 0;        ///< the task without a mistake did not pass
    int reviews = 0;          ///< a person was asked to look
    std::string seen;         ///< "failed shadow.hard", of the first decision that differed, if any
    bool asExpected = false;  ///< in every decision, and the other task passed without review
    double probeMs = 0.0;  ///< CPU of the submission's process for one decision, the largest seen
    double judgeMs = 0.0;  ///< CPU of the judgement itself, likewise
};

/// Makes the mistakes and the accepted readings of T2.1 and T2.2 in `reference` (Renderer.cpp of
/// the reference solution), compiles each and judges it.
/// @throws raytracer::Error where an edit does not fit or something does not compile.
[[nodiscard]] std::vector<CatalogueRow> runDistributedCatalogue(
    const std::vector<mistakes::Mistake>& catalogue, const std::string& reference,
    const build::Kit& kit, const sandbox::Sandbox& sandbox, const CatalogueRun& run);

/// One line for each row, those that differ marked, and a summary.
[[nodiscard]] std::string tableOf(const std::vector<CatalogueRow>& rows);

/// What the rows say together, as Markdown: how often accepted readings failed and mistakes passed,
/// with upper bounds of 95 % confidence (Clopper and Pearson; 3 / n where none did), and the share
/// of right names.
[[nodiscard]] std::string recordOf(const std::vector<CatalogueRow>& rows);

}  // namespace ticker::selftest

#endif
