#include <grader/cli/VerbProgram.h>
#include <grader/lab/LabVerbs.h>

#include <vector>

// Only CLI11 could throw, at options that are declared wrongly.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
    using namespace ticker::cli;
    std::vector<AddVerb> verbs{addSelftest, addCalibrate, addRepairsLab, addSimilarity};
#ifdef TICKER_HAS_COVERAGE
    verbs.push_back(addCoverage);
#endif
    return runProgram({"ticker-lab", "Tries the grader on submissions whose result is known."},
                      verbs, argc, argv);
}
