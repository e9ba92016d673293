#ifndef SUPPORT_COMPLAINT_H
#define SUPPORT_COMPLAINT_H

#include <ostream>
#include <string>

namespace raytracer::tests {

/// What a failed public test says.
struct Complaint {
    std::string asked;     ///< the input
    std::string expected;  ///< in words where a number would give the answer away
    std::string got;
    std::string cause;    ///< what is likely wrong
    std::string section;  ///< of the handout
};

std::ostream& operator<<(std::ostream& stream, const Complaint& complaint);

/// Numbers as a person reads them: four digits.
[[nodiscard]] std::string inWords(double value);
/// "13 %"
[[nodiscard]] std::string percent(double share);

}  // namespace raytracer::tests

#endif
