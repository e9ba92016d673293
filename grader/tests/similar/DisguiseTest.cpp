#include <grader/lab/similar/Disguise.h>
#include <grader/lab/similar/TokenText.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker::similar {
namespace {

const std::string kSource = R"(// Mine.
double area(double width) {
    const double half = width * kPart;
    const double other = 'a' + 2.5e3;
    double sum = 0.0;
    for (int i = 0; i < kCount; ++i) { sum += half; }
    return sum;
}
)";

std::string copyOf(Disguise disguise) {
    return disguised(disguise, kSource, {"double", "const", "int", "for", "return", "kCount"},
                     "// Another's.\nint x;\n");
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Tokens, TogetherAreTheText) {
    const std::string odd = "#include <a>\n/* b */ \"c\\\"d\" 'e' 1.5e3 f->g ::h // i";
    EXPECT_EQ(sourceOf(tokensOf(odd)), odd);
    EXPECT_EQ(sourceOf(tokensOf(kSource)), kSource);
    EXPECT_EQ(sourceOf(tokensOf("\"open")), "\"open");
}

TEST(Disguise, OfNamesKeepsThoseOfTheKit) {
    const std::string copy = copyOf(Disguise::names);
    EXPECT_FALSE(has(copy, "half")) << copy;
    EXPECT_TRUE(has(copy, "kCount")) << copy;
}

TEST(Disguise, OfOrderExchangesDeclarationsThatDoNotNeedEachOther) {
    const std::string copy = copyOf(Disguise::order);
    EXPECT_LT(copy.find("const double other"), copy.find("const double half")) << copy;
}

TEST(Disguise, OfCommentsKeepsTheCode) {
    const std::string copy = copyOf(Disguise::comments);
    EXPECT_FALSE(has(copy, "Mine")) << copy;
    EXPECT_TRUE(has(copy, "width * kPart")) << copy;
}

TEST(Disguise, OfExpressionsWritesThemInAnotherWay) {
    const std::string copy = copyOf(Disguise::expressions);
    EXPECT_TRUE(has(copy, "kPart * width")) << copy;
    EXPECT_TRUE(has(copy, "kCount > i")) << copy;
    EXPECT_TRUE(has(copy, "i += 1")) << copy;
    EXPECT_TRUE(has(copy, "sum = sum + ( half)")) << copy;
}

TEST(Disguise, OfPartsIsHalfAnothers) {
    const std::string copy = copyOf(Disguise::parts);
    EXPECT_TRUE(has(copy, "Mine")) << copy;
    EXPECT_TRUE(has(copy, "int x;")) << copy;
    EXPECT_FALSE(has(copy, "return sum")) << copy;
}

}  // namespace
}  // namespace ticker::similar
