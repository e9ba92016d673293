#ifndef TICKER_TESTS_STUDENT_PACKAGEALONE_H
#define TICKER_TESTS_STUDENT_PACKAGEALONE_H

#include <grader/tests/student/UnpackedPackage.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace ticker::tests {

/// One package and one build for all tests, as for a student: each test first writes its own two
/// files.
class PackageAlone : public ::testing::Test {
protected:
    static const UnpackedPackage& package() {
        static const UnpackedPackage unpacked;
        return unpacked;
    }

    /// Writes both files, from a folder of the project.
    static void putSolution(const std::string& folder) {
        put("BumpySphere.cpp", readFile(folder + "/BumpySphere.cpp"));
        put("Renderer.cpp", readFile(folder + "/Renderer.cpp"));
    }

    static void put(const std::string& name, const std::string& text) {
        std::ofstream{package().folder() / "exercise" / name} << text;
    }
};

}  // namespace ticker::tests

#endif
