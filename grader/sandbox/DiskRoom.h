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

/// Shares out the free space of a disk among jobs. Each job reserves the most that it may write
/// before it starts, so that no job finds the disk filled by another. Safe to share between
/// threads.
class DiskRoom {
public:
    /// @param freeBytes  Returns the free bytes of the disk at the time of the call.
    explicit DiskRoom(std::function<std::uint64_t()> freeBytes)
        : freeBytes_(std::move(freeBytes)) {}

    /// The reservation of one job, released on destruction.
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

    /// Waits while other jobs hold the missing bytes. Empty: the disk has less free space, and no
    /// job holds any of it.
    [[nodiscard]] std::optional<Share> take(std::uint64_t bytes);

    [[nodiscard]] std::uint64_t freeBytes() const { return freeBytes_(); }

private:
    void giveBack(std::uint64_t bytes);

    std::function<std::uint64_t()> freeBytes_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint64_t taken_ = 0;
};

/// Bytes that an ordinary user may still write below `folder`.
[[nodiscard]] std::uint64_t freeBytesOf(const std::filesystem::path& folder);

}  // namespace ticker::sandbox

#endif
