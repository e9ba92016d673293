#ifndef RAYTRACER_APP_VIEW_BOARD_H
#define RAYTRACER_APP_VIEW_BOARD_H

#include <raytracer/base/RenderSettings.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer::view {

/// What the page shows, as JSON that says only what is new. All threads write it, every page reads
/// it.
class Board {
public:
    /// A part of a picture; `head` is JSON of its place and stage, `rgb` its pixels.
    struct Piece {
        std::string head;
        std::string rgb;
        bool isWhole = false;  ///< covers all pieces before it
    };

    /// Sets one entry of the board. @param value  JSON.
    void set(const std::string& name, const std::string& value);

    /// Begins a picture. What belongs to an earlier one is dropped from here on.
    /// @param head  JSON of its size and number.
    void beginPicture(int number, const std::string& head);
    void addPiece(int number, const Piece& piece);

    /// Waits until there is something newer than `version`, and gives it with the version that it
    /// is up to; after a while also without news.
    [[nodiscard]] std::string newsAfter(std::uint64_t version);

    /// Lets everything that waits go.
    void close();

private:
    struct Entry {
        std::uint64_t version = 0;
        std::string json;
    };

    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint64_t version_ = 0;
    bool isClosed_ = false;
    int picture_ = 0;
    std::map<std::string, Entry> entries_;
    std::vector<Entry> pieces_;
};

}  // namespace raytracer::view

#endif
