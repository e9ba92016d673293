#include <support/Complaint.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

namespace raytracer::tests {

void complain(const std::string& asked, const std::string& expected, const std::string& got,
              const std::string& cause, const std::string& section) {
    ADD_FAILURE() << Complaint{asked, expected, got, cause, section};
}

std::ostream& operator<<(std::ostream& stream, const Complaint& complaint) {
    return stream << "  asked:    " << complaint.asked << '\n'
                  << "  expected: " << complaint.expected << '\n'
                  << "  got:      " << complaint.got << '\n'
                  << "  likely:   " << complaint.cause << '\n'
                  << "  handout:  " << complaint.section;
}

std::string inWords(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

std::string percent(double share) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.0f %%", 100.0 * share);
    return text.data();
}

}  // namespace raytracer::tests
