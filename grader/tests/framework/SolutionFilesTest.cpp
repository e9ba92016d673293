#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ticker {
namespace {

const std::string kRoot = TICKER_SOURCE_DIR;

std::string readFile(const std::string& path) {
    std::ifstream file{path, std::ios::binary};
    EXPECT_TRUE(file) << path;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// The text with everything between the marks of a task left out; `parts` counts them.
std::pair<std::string, int> outsideMarks(const std::string& text) {
    std::istringstream lines{text};
    std::ostringstream outside;
    int parts = 0;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        const bool begins = line.find("// TASK ") != std::string::npos && line.ends_with(" begin");
        const bool ends = line.find("// TASK ") != std::string::npos && line.ends_with(" end");
        EXPECT_FALSE(begins && inside) << line;
        if (ends) inside = false;
        if (!inside) outside << line << '\n';
        if (begins) inside = true;
        parts += static_cast<int>(begins);
    }
    EXPECT_FALSE(inside);
    return {outside.str(), parts};
}

void expectEqualOutsideMarks(const std::string& file, int tasks,
                             const std::string& exercise = "/exercise/") {
    const auto [stub, stubParts] =
        outsideMarks(readFile(kRoot + "/student_template" + exercise + file));
    const auto [reference, referenceParts] =
        outsideMarks(readFile(kRoot + "/reference_solution" + exercise + file));
    EXPECT_EQ(reference, stub);
    EXPECT_EQ(stubParts, tasks);
    EXPECT_EQ(referenceParts, tasks);
}

TEST(ReferenceSolution, EqualsTheTemplateOutsideTheTaskMarks) {
    expectEqualOutsideMarks("BumpySphere.cpp", 1);
    expectEqualOutsideMarks("Renderer.cpp", 2);
    expectEqualOutsideMarks("Sphere.cpp", 1, "/tick1/exercise/");
    expectEqualOutsideMarks("Plane.cpp", 1, "/tick1/exercise/");
    expectEqualOutsideMarks("Renderer.cpp", 3, "/tick1/exercise/");
}

TEST(ReferenceSolution, HasNoStubLeftAndTheTemplateHasEachOnce) {
    for (const std::string file : {"BumpySphere.cpp", "Renderer.cpp"}) {
        const std::string reference = readFile(kRoot + "/reference_solution/exercise/" + file);
        EXPECT_EQ(reference.find("unfinished("), std::string::npos) << file;
    }
    const std::string bumpy = readFile(kRoot + "/student_template/exercise/BumpySphere.cpp");
    const std::string renderer = readFile(kRoot + "/student_template/exercise/Renderer.cpp");
    EXPECT_NE(bumpy.find("unfinished(\"T1\""), std::string::npos);
    EXPECT_NE(renderer.find("unfinished(\"T2.1\""), std::string::npos);
    EXPECT_NE(renderer.find("unfinished(\"T2.2\""), std::string::npos);
}

}  // namespace
}  // namespace ticker
