#ifndef TICKER_CALIBRATE_AGREEMENTCASES_H
#define TICKER_CALIBRATE_AGREEMENTCASES_H

#include <grader/corpus/Entry.h>
#include <grader/exercise/Exercise.h>
#include <grader/oracle/Reading.h>

#include <string>
#include <vector>

namespace ticker::calibrate {

/// One accepted reading in both languages: an edit of the reference solution, and what the oracle
/// is told.
struct AgreementCase {
    std::string name;  ///< "surface"
    std::string file;  ///< which file of the reference is edited
    std::vector<corpus::Edit> edits;
    oracle::Reading reading;

    /// Whether it is about the relief alone, in which nothing is random.
    [[nodiscard]] bool isBump() const { return file == theExercise().files().front(); }
};

/// The accepted readings (docs/decisions/0003), one at a time, and all at once.
/// @param catalogue  Where the edits of T2.1 and T2.2 stand, as "accepted-...".
/// @throws raytracer::InputError where the catalogue has no such entry.
[[nodiscard]] std::vector<AgreementCase> agreementCases(
    const std::vector<corpus::Entry>& catalogue);

}  // namespace ticker::calibrate

#endif
