#ifndef TICKER_SANDBOX_DISKROOM_H
#define TICKER_SANDBOX_DISKROOM_H

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>

namespace ticker::sandbox {

/// The free room of a disk that jobs share. Each job takes the most that it may fill before it
/// begins, so that no job finds the disk filled by another. May be shared by threads.
class DiskRoom {
public:
    /// @param freeBytes  What is free on the disk at this moment.
    explicit DiskRoom(std::function<std::uint64_t()> freeBytes)
        : freeBytes_(std::move(freeBytes)) {}

    /// What one job has taken, given back at its end.
    class Share {
    public:
        Share(DiskRoom& room, std::uint64_t bytes) : room_(&room), bytes_(bytes) {}
        ~Share() {
            if (room_ != nullptr) room_->giveBack(bytes_);
        }
        Share(Share&& other) noexcept
            : room_(std::exchange(other.room_, nullptr)), bytes_(other.bytes_) {}
        Share(const Share&) = delete;
        Share& operator=(const Share&) = delete;
        Share& operator=(Share&&) = delete;

    private:
        DiskRoom* room_;
        std::uint64_t bytes_;
    };

    /// Waits while other jobs hold what is missing. Empty: the disk has less, and no job holds any.
    [[nodiscard]] std::optional<Share> take(std::uint64_t bytes);

    [[nodiscard]] std::uint64_t freeBytes() const { return freeBytes_(); }

private:
    void giveBack(std::uint64_t bytes);

    std::function<std::uint64_t()> freeBytes_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint64_t taken_ = 0;
};

/// What an ordinary user may still write below `folder`, bytes.
[[nodiscard]] std::uint64_t freeBytesOf(const std::filesystem::path& folder);

}  // namespace ticker::sandbox

#endif
