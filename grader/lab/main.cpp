#include <grader/cli/Program.h>
#include <grader/lab/LabVerbs.h>

// Only CLI11 could throw, at options that are declared wrongly.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
    using namespace ticker::cli;
    return runProgram({"ticker-lab", "Tries the grader on submissions whose result is known."},
                      {addSelftest, addCalibrate, addRepairsLab}, argc, argv);
}
