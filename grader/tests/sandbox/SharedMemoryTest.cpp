#include <grader/sandbox/SharedMemory.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <array>

namespace ticker::sandbox {
namespace {

TEST(SharedMemory, HoldsZerosAndWhatEitherSideWrote) {
    const SharedMemory memory{8192};
    const std::array ours{std::byte{1}, std::byte{2}};
    const std::array theirs{std::byte{3}};
    memory.write(4095, ours);
    ASSERT_EQ(pwrite(memory.descriptor(), theirs.data(), theirs.size(), 4097), 1);

    std::array<std::byte, 4> read{std::byte{9}, std::byte{9}, std::byte{9}, std::byte{9}};
    memory.read(4094, read);

    EXPECT_EQ(read, (std::array{std::byte{0}, std::byte{1}, std::byte{2}, std::byte{3}}));
}

TEST(SharedMemory, NeitherGrowsNorShrinks) {
    const SharedMemory memory{16};
    const std::array<std::byte, 8> bytes{};
    EXPECT_THROW(memory.write(16, bytes), raytracer::Error);
    std::array<std::byte, 8> read{};
    EXPECT_THROW(memory.read(16, read), raytracer::Error);
    EXPECT_NE(ftruncate(memory.descriptor(), 8), 0);
}

}  // namespace
}  // namespace ticker::sandbox
