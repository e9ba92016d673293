#include <grader/lab/calibrate/Document.h>

#include <gtest/gtest.h>

namespace ticker::calibrate {
namespace {

const std::string kDocument =
    "# Title\nWords.\n<!-- calibrate: correct -->\nold\n<!-- end -->\nMore words.\n";

TEST(Document, HasTheSectionReplacedAndNothingElse) {
    EXPECT_EQ(sectionOf(kDocument, "correct"), "old\n");
    EXPECT_EQ(withSection(kDocument, "correct", "new"),
              "# Title\nWords.\n<!-- calibrate: correct -->\nnew\n<!-- end -->\nMore words.\n");
}

TEST(Document, GetsASectionThatWasMissing) {
    EXPECT_EQ(sectionOf(kDocument, "stages"), "");
    const std::string longer = withSection(kDocument, "stages", "table\n");
    EXPECT_EQ(sectionOf(longer, "stages"), "table\n");
    EXPECT_EQ(sectionOf(longer, "correct"), "old\n");
}

}  // namespace
}  // namespace ticker::calibrate
