#include <grader/repair/EditCost.h>
#include <grader/repair/EditSets.h>
#include <grader/repair/LineEdits.h>
#include <grader/result/ProvenLine.h>
#include <grader/result/ResultJson.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace ticker::repair {
namespace {

constexpr std::string_view kSource = "a = f(0.0, s);\nb = f(0.0, s);\nc = a - b;\n";

Atom atom(std::string kind, TextEdit edit, std::size_t begin, std::size_t end) {
    Atom made;
    made.kind = std::move(kind);
    made.edits = {std::move(edit)};
    made.statementBegin = begin;
    made.statementEnd = end;
    return made;
}

/// The same bound in two lines, and an operator in the third.
Candidates candidates() {
    Candidates made;
    made.atoms = {atom("bound", {6, 9, "-s"}, 0, 13), atom("bound", {21, 24, "-s"}, 15, 28),
                  atom("operator", {36, 37, "+"}, 30, 39)};
    return made;
}

bool isAny(const Atom& /*atom*/) {
    return true;
}

TEST(EditSets, JoinNoEditsOfWhichOneReplacesTheSwitchOfTheOther) {
    constexpr std::string_view kSum = "a + b + c;";
    Candidates made;
    made.atoms = {atom("operator", {2, 3, "-"}, 0, 9), atom("operator", {6, 7, "-"}, 0, 9)};
    EXPECT_EQ(pairs(kSum, made, isAny).size(), 1U);
    std::tie(made.atoms[0].siteBegin, made.atoms[0].siteEnd) = std::pair{0, 5};
    std::tie(made.atoms[1].siteBegin, made.atoms[1].siteEnd) = std::pair{0, 9};
    EXPECT_TRUE(pairs(kSum, made, isAny).empty());
    EXPECT_TRUE(twins(kSum, made, isAny).empty());
}

TEST(EditSets, OneTokenForAnotherCountsOnce) {
    EXPECT_EQ(tokensChanged(kSource, candidates(), {2}), 1U);
    EXPECT_EQ(tokensChanged(kSource, candidates(), {0, 1}), 4U);
}

TEST(EditSets, TheSimplestComesFirst) {
    const auto sets = singles(kSource, candidates(), isAny);
    ASSERT_EQ(sets.size(), 3U);
    EXPECT_EQ(sets.front(), EditSet{2});
}

TEST(EditSets, TheSameEditAtTwoPlacesIsOneSet) {
    const auto sets = twins(kSource, candidates(), isAny);
    EXPECT_EQ(sets, (std::vector<EditSet>{{0, 1}}));
}

TEST(EditSets, ManyWordsThatSayOneThingAreSimple) {
    Candidates made = candidates();
    made.atoms.push_back(atom("sibling", {30, 31, "a + b"}, 30, 39));
    made.atoms.push_back(atom("draw", {36, 37, "draw(0.0, s) + draw(0.0, s)"}, 30, 39));
    const auto sets = singles(kSource, made, isAny);
    EXPECT_EQ(sets, (std::vector<EditSet>{{2}, {4}, {0}, {1}, {3}}));
}

TEST(EditSets, TheSameEditTwiceInOneStatementIsOneSetHoweverOftenItIsPossible) {
    constexpr std::string_view kLong = "a+b+c; d+e+f; g+h+i;";
    Candidates made;
    for (const std::size_t at : {1U, 3U, 8U, 10U, 15U, 17U}) {
        const std::size_t begin = at / 7 * 7;
        made.atoms.push_back(atom("operator", {at, at + 1, "-"}, begin, begin + 5));
    }
    const auto sets = twins(kLong, made, isAny);
    EXPECT_NE(std::ranges::find(sets, EditSet{2, 3}), sets.end());
    EXPECT_EQ(std::ranges::find(sets, EditSet{0, 1, 2, 3, 4, 5}), sets.end());
}

TEST(EditSets, AmongEqualsTheSmallerPlaceComesFirst) {
    constexpr std::string_view kRoots = "c = f(a) - r * r; d = a * c;";
    Candidates made;
    made.atoms = {atom("factor", {4, 16, "(f(a) - r * r) * 4.0"}, 0, 16),
                  atom("factor", {22, 27, "a * c * 4.0"}, 18, 27)};
    EXPECT_EQ(singles(kRoots, made, isAny), (std::vector<EditSet>{{1}, {0}}));
}

TEST(EditSets, TheSameNameAtThreeOfFourPlacesIsOneSet) {
    constexpr std::string_view kNames = "f(v); g(v, 1); h(v, 1, 2); k(v, 1, 2, 3);";
    Candidates made;
    for (const std::size_t at : {2U, 8U, 17U, 29U})
        made.atoms.push_back(atom("name", {at, at + 1, "w"}, at - 2, at + 2));
    const auto sets = twins(kNames, made, isAny);
    EXPECT_NE(std::ranges::find(sets, EditSet{0, 1, 2}), sets.end());
    EXPECT_NE(std::ranges::find(sets, EditSet{0, 1, 2, 3}), sets.end());
}

TEST(EditSets, TwoSignsOrTwoStatementsLeftOutBelongTogether) {
    constexpr std::string_view kTwo = "v = a + b; n = p - q; f(v); g(n);";
    Candidates made;
    made.atoms = {atom("operator", {6, 7, "-"}, 0, 9), atom("operator", {17, 18, "+"}, 11, 20),
                  atom("left-out", {22, 27, ""}, 22, 26), atom("left-out", {28, 33, ""}, 28, 32),
                  atom("operator", {6, 7, "*"}, 0, 9)};
    const auto sets = linked(kTwo, made, isAny);
    EXPECT_EQ(sets.size(), 2U);
    EXPECT_NE(std::ranges::find(sets, EditSet{0, 1}), sets.end());
    EXPECT_NE(std::ranges::find(sets, EditSet{2, 3}), sets.end());
}

TEST(EditSets, EditsOfAnotherTaskTakeNoPart) {
    const auto chosen = [](const Atom& each) { return each.kind == "operator"; };
    EXPECT_EQ(singles(kSource, candidates(), chosen), (std::vector<EditSet>{{2}}));
    EXPECT_TRUE(twins(kSource, candidates(), chosen).empty());
}

TEST(WithEdits, RefusesEditsOfTheSameText) {
    EXPECT_FALSE(withEdits(kSource, {{6, 9, "1"}, {8, 10, "2"}}));
    EXPECT_FALSE(withEdits(kSource, {{40, 90, ""}}));
    EXPECT_EQ(withEdits("ab", {{1, 1, "-"}}), "a-b");
}

TEST(LineEdits, ShowsWholeLinesBeforeAndAfter) {
    const auto lines = lineEdits(kSource, textEdits(candidates(), {0, 2}));
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].line, 1);
    EXPECT_EQ(lines[0].from, "a = f(0.0, s);");
    EXPECT_EQ(lines[0].to, "a = f(-s, s);");
    EXPECT_EQ(lines[1].line, 3);
    EXPECT_EQ(lines[1].to, "c = a + b;");
}

TEST(LineEdits, LeavesNothingOfALineWhoseOnlyStatementIsLeftOut) {
    const auto lines = lineEdits("a = 1;\n  b = a;\n", {{9, 15, ""}});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].from, "  b = a;");
    EXPECT_EQ(lines[0].to, "");
}

TEST(LineEdits, AreTheSameWhateverEndsTheLines) {
    const auto lines = lineEdits("a;\r\nf(a,\r\n  b);\r\n", {{0, 1, "c"}, {6, 13, "c,\r\n  d"}});
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].from, "a;");
    EXPECT_EQ(lines[0].to, "c;");
    EXPECT_EQ(lines[1].line, 2);
    EXPECT_EQ(lines[1].from, "f(a,\n  b);");
    EXPECT_EQ(lines[1].to, "f(c,\n  d);");
}

// Otherwise a result that is read again would be another one than that which was stored.
TEST(LineEdits, AreReadFromAResultFileAsTheyWereWritten) {
    SubmissionResult result;
    result.repairs = std::vector<Repair>{{"T1", "bump.flat", "BumpySphere.cpp",
                                          lineEdits("a; // gr\xfcn\r\n", {{0, 1, "b"}}), true, ""}};
    const SubmissionResult again = parseResultJson(resultJson(result), "result.json");
    EXPECT_EQ(provenLines(again), provenLines(result));
    EXPECT_EQ(again.repairs->front().edits.front().from, "a; // gr\uFFFDn");
}

TEST(LineEdits, NamesTheLineThatChangesWithinALongStatement) {
    const auto lines = lineEdits("f(a,\n  b);", {{0, 9, "f(a,\n  c)"}});
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].line, 2);
    EXPECT_EQ(lines[0].from, "  b);");
}

}  // namespace
}  // namespace ticker::repair
