#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker {
namespace {

/// A source with the flips of tools/mutation_check, built, and run with one flip after the other.
class Flips : public testing::Test {
protected:
    [[nodiscard]] std::string outputsOf(const std::string& source, int flips) const {
        folder_.write("a.cpp", source);
        const std::string tool = TICKER_SOURCE_DIR "/tools/mutation_check/";
        const tests::CommandResult ran = tests::runCommand(
            "cd '" + folder_.path().string() + "' && awk -f " + tool +
            "sites.awk a.cpp > sites && awk -f " + tool +
            "insert.awk sites /dev/null a.cpp > b.cpp && g++ -std=c++20 -I '" TICKER_SOURCE_DIR
            "' b.cpp -o b && for n in $(seq -1 " +
            std::to_string(flips - 1) + "); do FLIP=$n ./b; done");
        EXPECT_EQ(ran.status, 0);
        return ran.output;
    }

    tests::TemporaryFolder folder_;
};

constexpr const char* kPrint =
    "#include <cstdio>\n"
    "bool f(int a, int b);\n"
    "double g(double a, double b);\n"
    "int main() { std::printf(\"%d%d%d %g\\n\", f(1, 2), f(2, 1), f(2, 2), g(3, 1)); }\n";

TEST_F(Flips, TurnComparisonsRoundOneAtATime) {
    EXPECT_EQ(outputsOf(std::string{kPrint} + "bool f(int a, int b) { return a < b; }\n"
                                              "double g(double, double) { return 0; }\n",
                        1),
              "100 0\n011 0\n");
}

TEST_F(Flips, LeaveTheOrderOfOperationsAlone) {
    EXPECT_EQ(outputsOf(std::string{kPrint} + "bool f(int, int) { return true; }\n"
                                              "double g(double a, double b) {\n"
                                              "    return 2 * a - b + 10 * b;\n"
                                              "}\n",
                        2),
              "111 15\n111 -5\n111 17\n");
}

TEST_F(Flips, MakeAConjunctionFalseAndADisjunctionTrue) {
    EXPECT_EQ(outputsOf(std::string{kPrint} + "bool yes(int a) { return a > 1; }\n"
                                              "bool f(int a, int b) { return yes(a) && yes(b); }\n"
                                              "double g(double, double b) {\n"
                                              "    return yes(int(b)) || yes(int(b));\n"
                                              "}\n",
                        3),
              "001 0\n000 1\n000 0\n001 1\n");
}

TEST_F(Flips, ChangeConstants) {
    EXPECT_EQ(outputsOf(std::string{kPrint} + "constexpr double kBound = 0.5;\n"
                                              "bool f(int, int) { return true; }\n"
                                              "double g(double, double) { return kBound; }\n",
                        1),
              "111 0.5\n111 5\n");
}

}  // namespace
}  // namespace ticker
