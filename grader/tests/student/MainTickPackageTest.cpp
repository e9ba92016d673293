#include <grader/tests/student/UnpackedPackage.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/ShellBlocks.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace ticker {
namespace {

namespace fs = std::filesystem;

/// The package of the main tick, built once for all tests.
class MainTickPackage : public ::testing::Test {
protected:
    static const tests::UnpackedPackage& package() {
        static const tests::UnpackedPackage unpacked{exerciseNamed("tick1")};
        return unpacked;
    }

    static void put(const std::string& folder) {
        for (const char* file : {"Sphere.cpp", "Plane.cpp", "Renderer.cpp"})
            std::ofstream{package().folder() / "exercise" / file}
                << tests::readFile(folder + "/" + file);
    }

    static std::string checked(int status) {
        const tests::CommandResult ran = package().runAlone("./check --quick");
        EXPECT_EQ(ran.status, status) << ran.output;
        return ran.output;
    }
};

TEST_F(MainTickPackage, HoldsNothingThatItsStudentsAreToWrite) {
    EXPECT_FALSE(fs::exists(package().folder() / "framework/src/main_tick"));
    EXPECT_FALSE(fs::exists(package().folder() / "tests/questions"));
    for (const fs::path& file : package().files()) {
        std::string text = tests::readFile(fs::relative(file, TICKER_SOURCE_DIR).string());
        for (const char* answer : {"phongKD() *", "- radius() * radius()", "(-ray.direction).ref"})
            EXPECT_TRUE(file.extension() == ".md" || text.find(answer) == std::string::npos)
                << file << ": " << answer;
    }
}

TEST_F(MainTickPackage, SaysWhatIsToDoAndPassesTheModelAnswer) {
    put("student_template/tick1/exercise");
    EXPECT_NE(checked(0).find("Nothing attempted yet"), std::string::npos);
    put("reference_solution/tick1/exercise");
    const std::string passed = checked(0);
    EXPECT_EQ(passed.find("NOT YET"), std::string::npos) << passed;
    EXPECT_NE(
        passed.find("Hand in exercise/Sphere.cpp, exercise/Plane.cpp and exercise/Renderer.cpp."),
        std::string::npos);
}

TEST_F(MainTickPackage, SaysWhereANaturalMistakeIs) {
    put("reference_solution/tick1/exercise");
    std::string text = tests::readFile("reference_solution/tick1/exercise/Renderer.cpp");
    text.replace(text.find("(-ray.direction)"), 16, "ray.direction");
    std::ofstream{package().folder() / "exercise/Renderer.cpp"} << text;
    const std::string output = checked(1);
    EXPECT_NE(output.find("NOT YET: M4"), std::string::npos) << output;
}

TEST_F(MainTickPackage, DoesWhatItsDocumentsSay) {
    put("reference_solution/tick1/exercise");
    for (const char* document : {"student_template/tick1/README.md", "docs/handout-tick1.md"}) {
        std::ofstream{package().folder() / "commands.sh"}
            << tests::scriptOf(tests::shellBlocks(document));
        const tests::CommandResult ran = package().runAlone("bash commands.sh");
        EXPECT_EQ(ran.status, 0) << ran.output;
    }
}

}  // namespace
}  // namespace ticker
