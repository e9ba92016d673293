#ifndef SUPPORT_COMPLAINT_H
#define SUPPORT_COMPLAINT_H

#include <ostream>
#include <string>

namespace raytracer::tests {

/// Text of a failed public test.
struct Complaint {
    std::string asked;     ///< the input
    std::string expected;  ///< in words if a number would reveal the answer
    std::string got;
    std::string cause;    ///< the likely mistake
    std::string section;  ///< section of the handout
};

/// Fails the running test.
void complain(const std::string& asked, const std::string& expected, const std::string& got,
              const std::string& cause, const std::string& section);

std::ostream& operator<<(std::ostream& stream, const Complaint& complaint);

/// A number with four significant digits.
[[nodiscard]] std::string inWords(double value);
/// "13 %"
[[nodiscard]] std::string percent(double share);

}  // namespace raytracer::tests

#endif
