#ifndef RAYTRACER_APP_VIEW_LINES_H
#define RAYTRACER_APP_VIEW_LINES_H

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace raytracer::view {

/// The pieces of a text between separators; one more than there are separators.
[[nodiscard]] inline std::vector<std::string> splitAt(std::string_view text, char separator) {
    std::vector<std::string> pieces;
    for (std::size_t end = text.find(separator); end != std::string_view::npos;
         end = text.find(separator)) {
        pieces.emplace_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    pieces.emplace_back(text);
    return pieces;
}

/// Takes lines, and blocks of bytes between them, from something that gives bytes now and then.
class LineReader {
public:
    /// Waits for bytes and gives their number; 0 at the end.
    using Source = std::function<std::size_t(char* bytes, std::size_t size)>;

    explicit LineReader(Source source) : source_(std::move(source)) {}

    /// The next line, without its end. Empty at the end of everything.
    [[nodiscard]] std::optional<std::string> next() {
        for (std::size_t seen = 0;;) {
            const std::size_t end = held_.find('\n', seen);
            if (end != std::string::npos) return take(end, 1);
            seen = held_.size();
            if (!more()) return std::nullopt;
        }
    }

    /// Exactly this many bytes. Empty where fewer come.
    [[nodiscard]] std::optional<std::string> block(std::size_t size) {
        while (held_.size() < size)
            if (!more()) return std::nullopt;
        return take(size, 0);
    }

private:
    std::string take(std::size_t size, std::size_t dropped) {
        std::string taken = held_.substr(0, size);
        held_.erase(0, size + dropped);
        return taken;
    }

    bool more() {
        constexpr std::size_t kChunk = 65536;
        const std::size_t before = held_.size();
        held_.resize(before + kChunk);
        const std::size_t got = source_(held_.data() + before, kChunk);
        held_.resize(before + got);
        return got > 0;
    }

    Source source_;
    std::string held_;
};

}  // namespace raytracer::view

#endif
