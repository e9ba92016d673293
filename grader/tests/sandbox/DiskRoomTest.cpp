#include <grader/sandbox/DiskRoom.h>

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace ticker::sandbox {
namespace {

TEST(DiskRoom, KeepsWhatOneJobMayFillFromTheOthers) {
    std::atomic<std::uint64_t> free{100};
    DiskRoom room{[&] { return free.load(); }};
    std::optional<DiskRoom::Share> first = room.take(60);
    ASSERT_TRUE(first);
    EXPECT_TRUE(room.take(40)) << "both have room";
    std::atomic<bool> hasSecond{false};
    std::thread second{[&] {
        const std::optional<DiskRoom::Share> share = room.take(60);
        hasSecond = share.has_value();
    }};
    // It must wait until the first gives its share back: 100 are free, 60 are taken.
    EXPECT_FALSE(hasSecond);
    first.reset();
    second.join();
    EXPECT_TRUE(hasSecond);
}

TEST(DiskRoom, RefusesWhatTheDiskHasNotWhereNoJobHoldsAny) {
    DiskRoom room{[] { return std::uint64_t{100}; }};
    EXPECT_FALSE(room.take(101));
    EXPECT_TRUE(room.take(100)) << "what was refused is not taken";
}

TEST(DiskRoom, RefusesAJobThatWaitedInVain) {
    std::atomic<std::uint64_t> free{100};
    DiskRoom room{[&] { return free.load(); }};
    std::optional<DiskRoom::Share> first = room.take(60);
    std::atomic<bool> isRefused{false};
    std::thread second{[&] { isRefused = !room.take(60).has_value(); }};
    free = 30;  // another process filled the disk
    first.reset();
    second.join();
    EXPECT_TRUE(isRefused);
}

TEST(DiskRoom, IsSharedByManyJobs) {
    DiskRoom room{[] { return std::uint64_t{100}; }};
    std::atomic<int> atOnce{0};
    std::atomic<int> most{0};
    std::vector<std::thread> jobs;
    for (int i = 0; i < 8; ++i)
        jobs.emplace_back([&] {
            for (int turn = 0; turn < 200; ++turn) {
                const std::optional<DiskRoom::Share> share = room.take(50);
                ASSERT_TRUE(share);
                const int now = ++atOnce;
                for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
                }
                --atOnce;
            }
        });
    for (std::thread& job : jobs)
        job.join();
    EXPECT_LE(most, 2);
}

TEST(DiskRoom, KnowsWhatIsFree) {
    EXPECT_GT(freeBytesOf("/tmp"), 0U);
    EXPECT_EQ(freeBytesOf("/not/there"), 0U);
}

}  // namespace
}  // namespace ticker::sandbox
