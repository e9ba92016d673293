#include <grader/base/WholeFile.h>
#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace ticker {
namespace {

/// A source with the flips of tools/mutation_check, built, and run with one flip after the other.
class Flips : public testing::Test {
protected:
    [[nodiscard]] std::string outputsOf(const std::string& source, int flips) const {
        folder_.write("a.cpp", source);
        const tests::CommandResult ran = tests::runCommand(
            "cd '" + folder_.path().string() + "' && awk -f " + kTool +
            "sites.awk a.cpp > sites && awk -f " + kTool +
            "insert.awk sites /dev/null a.cpp > b.cpp && g++ -std=c++20 -I '" TICKER_SOURCE_DIR
            "' b.cpp -o b && for n in $(seq -1 " +
            std::to_string(flips - 1) + "); do FLIP=$n ./b; done");
        EXPECT_EQ(ran.status, 0);
        return ran.output;
    }

    /// The code of the flips in the order in which a seed tries them.
    [[nodiscard]] std::string orderOf(const std::string& source, int seed) const {
        folder_.write("a.cpp", source);
        return inFolder("awk -f " + kTool +
                        "sites.awk a.cpp | awk -F'\\t' -v OFS='\\t' "
                        "'{ print $1, $2, $3, $4, $5, $7, $8, 0 }' | awk -f " +
                        kTool + "order.awk -v seed=" + std::to_string(seed) +
                        " | LC_ALL=C sort -n | cut -f8");
    }
    [[nodiscard]] std::string inFolder(const std::string& command) const {
        return tests::runCommand("cd '" + folder_.path().string() + "' && " + command).output;
    }

    inline static const std::string kTool{TICKER_SOURCE_DIR "/tools/mutation_check/"};
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

// What is tried stays the same when other code changes.
TEST_F(Flips, KeepTheirOrderWhereOtherLinesComeOrGo) {
    const std::string lines =
        "bool f(int a) { return a < 1; }\nbool g(int a) { return a > 2; }\n"
        "bool h(int a) { return a == 3; }\nbool k(int a) { return a <= 4; }\n";
    const std::string order = orderOf(lines, 1);
    EXPECT_EQ(std::ranges::count(order, '\n'), 4);
    std::string with = orderOf("bool more(int a) { return a >= 5; }\n" + lines, 1);
    const std::string added = "bool more(int a) { return a >= 5; }\n";
    ASSERT_NE(with.find(added), std::string::npos);
    with.erase(with.find(added), added.size());
    EXPECT_EQ(with, order);
    std::set<std::string> orders;
    for (int seed = 1; seed <= 8; ++seed)
        orders.insert(orderOf(lines, seed));
    EXPECT_GT(orders.size(), 3U);
}

TEST_F(Flips, DoNotCountWhereTheyAreEquivalent) {
    folder_.write("equivalent",
                  "FILE\tOLD\tNTH\tCODE\tREASON\n"
                  "grader/tasks/bump/a.cpp\t < \t1\tif (a < b)\tthe same\n");
    folder_.write("sample",
                  "0\tgrader/tasks/bump/a.cpp\t3\t9\t < \t1\tif (a < b)\tx\n"
                  "1\tgrader/tasks/bump/a.cpp\t4\t9\t > \t1\tif (a > b)\tx\n"
                  "2\tgrader/rubric/b.cpp\t5\t9\t == \t1\tif (a == b)\tx\n"
                  "3\tgrader/rubric/b.cpp\t6\t9\t == \t1\tif (c == b)\tx\n");
    folder_.write("results",
                  "grader/tasks/bump/a.cpp\t3\t9\t < \t1\tif (a < b)\tx\ty\tsurvived\t\n"
                  "grader/tasks/bump/a.cpp\t4\t9\t > \t1\tif (a > b)\tx\ty\tcaught\tt\n"
                  "grader/rubric/b.cpp\t5\t9\t == \t1\tif (a == b)\tx\ty\tnever-run\t\n");
    const std::string command = "awk -f " + kTool + "table.awk -v seed=1 -v least=90";
    const std::string said = inFolder(command + " equivalent sample results; echo $?");
    EXPECT_NE(said.find("1 of 2 noticed: 50.0 %, without 1 that are equivalent\n1\n"),
              std::string::npos)
        << said;
    EXPECT_NE(said.find("b.cpp:5` `==` in `if (a == b)`: no test comes here"), std::string::npos);
    const std::string table = inFolder(command + " -v markdown=yes equivalent sample results");
    EXPECT_NE(table.find("| `rubric` | 1 | 0 | 0 | 1 |\n| `tasks/bump` | 2 | 1 | 1 | 0 |"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("in `if (a < b)`: the same"), std::string::npos);
}

TEST_F(Flips, AreTriedAgainOnceTheTestThatNoticedThemIsAnotherOne) {
    folder_.write("blobs", "a.cpp\tx\n");
    folder_.write("now", "test_a\tA.IsKept\t11\ntest_a\tA.Changed\t13\n");
    const std::string row = "a.cpp\t3\t9\t < \t1\tif (a < b)\tx\told\t";
    const std::string kept = row + "caught\ttest_a A.IsKept\t11\n";
    folder_.write("results", kept + row + "caught\ttest_a A.Changed\t12\n" + row +
                                 "caught\ttest_a A.Deleted\t12\n" + row + "survived\t\t\n");
    const std::string command = "awk -f " + kTool + "kept.awk -v tests=";
    EXPECT_EQ(inFolder(command + "new blobs now results"), kept);
    EXPECT_EQ(inFolder(command + "old blobs now results"), kept + row + "survived\t\t\n");
}

// A flip in a folder whose tests are not asked would count as not noticed.
TEST_F(Flips, AreAskedOfTheTestsOfEveryTask) {
    const std::string programs =
        inFolder("sed -n '/^programs=/,/)$/p' " + kTool + "mutation_check");
    for (const auto& folder : std::filesystem::directory_iterator{
             std::filesystem::path{TICKER_SOURCE_DIR} / "grader/tests/tasks"}) {
        const std::string lists = readWhole(folder.path() / "CMakeLists.txt");
        const std::size_t name = lists.find("ticker_test(NAME ") + 17;
        const std::string program =
            "test_" + lists.substr(name, lists.find_first_of(" \n", name) - name);
        EXPECT_NE(programs.find(program), std::string::npos) << program;
    }
}

// A row that fits no line excuses nothing: its flip would be counted as not noticed.
TEST(EquivalentFlips, StandInTheirFiles) {
    const std::filesystem::path root{TICKER_SOURCE_DIR};
    std::ifstream table{root / "tools/mutation_check/equivalent.tsv"};
    std::string row;
    ASSERT_TRUE(std::getline(table, row)) << "no heading";
    int rows = 0;
    for (; std::getline(table, row); ++rows) {
        std::istringstream fields{row};
        std::string file;
        std::string old;
        std::string nth;
        std::string code;
        for (std::string* field : {&file, &old, &nth, &code})
            std::getline(fields, *field, '\t');
        EXPECT_NE(readWhole(root / file).find(code), std::string::npos) << row;
        EXPECT_NE(code.find(old), std::string::npos) << row;
    }
    EXPECT_GT(rows, 10);
}

}  // namespace
}  // namespace ticker
