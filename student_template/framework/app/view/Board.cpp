#include "Board.h"

#include "Json.h"

namespace raytracer::view {
namespace {

constexpr std::chrono::seconds kLongestWait{10};

}  // namespace

void Board::set(const std::string& name, const std::string& value) {
    const std::lock_guard lock{mutex_};
    entries_[name] = {++version_, value};
    changed_.notify_all();
}

void Board::beginPicture(int number, const std::string& head) {
    const std::lock_guard lock{mutex_};
    picture_ = number;
    pieces_.clear();
    entries_["picture"] = {++version_, head};
    changed_.notify_all();
}

void Board::addPiece(int number, const Piece& piece) {
    const std::lock_guard lock{mutex_};
    if (number != picture_) return;
    if (piece.isWhole) pieces_.clear();
    pieces_.push_back(
        {++version_, Members{}.add("at", piece.head).add("rgb", json(base64(piece.rgb))).object()});
    changed_.notify_all();
}

std::string Board::newsAfter(std::uint64_t version) {
    std::unique_lock lock{mutex_};
    changed_.wait_for(lock, kLongestWait, [&] { return isClosed_ || version_ > version; });
    Members news;
    news.add("version", std::to_string(version_));
    for (const auto& [name, entry] : entries_)
        if (entry.version > version) news.add(name, entry.json);
    Items pieces;
    for (const Entry& piece : pieces_)
        if (piece.version > version) pieces.add(piece.json);
    return news.add("pieces", pieces.array()).object();
}

void Board::close() {
    const std::lock_guard lock{mutex_};
    isClosed_ = true;
    changed_.notify_all();
}

}  // namespace raytracer::view
