#ifndef TICKER_LAB_LABVERBS_H
#define TICKER_LAB_LABVERBS_H

#include <grader/cli/verbs/Verb.h>

namespace ticker::cli {

// The verbs of ticker-lab; see Verb.h.
Run addSelftest(CLI::App& app, const GlobalOptions& global);
Run addCalibrate(CLI::App& app, const GlobalOptions& global);
Run addRepairsLab(CLI::App& app, const GlobalOptions& global);
Run addSimilarity(CLI::App& app, const GlobalOptions& global);
#ifdef TICKER_HAS_COVERAGE  // where the public tests are built
Run addCoverage(CLI::App& app, const GlobalOptions& global);
#endif

}  // namespace ticker::cli

#endif
