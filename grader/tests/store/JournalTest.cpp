#include <grader/store/Journal.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

namespace ticker::store {
namespace {

TEST(Journal, KnowsTheFileSystemsThatOtherMachinesWriteTo) {
    for (const std::int64_t type : {0x6969L, 0xFF534D42L, 0xFE534D42L, 0x0BD00BD0L, 0x65735546L})
        EXPECT_TRUE(isNetworkFileSystem(type)) << std::hex << type;
    EXPECT_TRUE(isNetworkFileSystem(static_cast<std::int32_t>(0xFF534D42U))) << "32 bits, signed";
    for (const std::int64_t type :
         {0xEF53L, 0x58465342L, 0x9123683EL, 0x01021994L, 0x794C7630L, 0x2FC12FC1L})
        EXPECT_FALSE(isNetworkFileSystem(type)) << std::hex << type;
}

TEST(Journal, WritesAheadInAnOrdinaryFolder) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(journalFor(folder.path()), Journal::writeAhead);
}

}  // namespace
}  // namespace ticker::store
