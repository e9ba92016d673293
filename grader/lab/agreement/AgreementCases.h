#ifndef TICKER_CALIBRATE_AGREEMENTCASES_H
#define TICKER_CALIBRATE_AGREEMENTCASES_H

#include <grader/corpus/Entry.h>
#include <grader/exercise/Exercise.h>
#include <grader/oracle/Reading.h>

#include <string>
#include <vector>

namespace ticker::calibrate {

/// One accepted reading in two forms: as an edit of the reference solution, and as the oracle's
/// reading.
struct AgreementCase {
    std::string name;  ///< "surface"
    std::string file;  ///< the edited file of the reference
    std::vector<corpus::Edit> edits;
    oracle::Reading reading;

    /// Whether it is a reading of bump mapping, whose renders have no random rays.
    [[nodiscard]] bool isBump() const { return file == defaultExercise().files().front(); }
};

/// The accepted readings (docs/decisions/0003), one at a time, and all at once.
/// @param catalogue  Contains the edits as "accepted-...".
/// @throws raytracer::InputError if the catalogue lacks an entry.
[[nodiscard]] std::vector<AgreementCase> agreementCases(
    const std::vector<corpus::Entry>& catalogue);

}  // namespace ticker::calibrate

#endif
