#include "TerminalPicture.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace ticker {
namespace {

using Colour = std::array<std::uint8_t, 3>;

struct Cell {
    Colour upper{};
    Colour lower{};
};

Colour colourOf256(int number) {
    static constexpr std::array<std::uint8_t, 6> kLevels{0, 95, 135, 175, 215, 255};
    if (number >= 232) {
        const auto grey = static_cast<std::uint8_t>(8 + 10 * (number - 232));
        return {grey, grey, grey};
    }
    if (number < 16) return {};  // the preview uses none of the system's 16 colours
    const auto level = [](int index) { return kLevels[static_cast<std::size_t>(index)]; };
    return {level((number - 16) / 36), level((number - 16) / 6 % 6), level((number - 16) % 6)};
}

class Screen {
public:
    void write(std::string_view text) {
        while (!text.empty())
            text.remove_prefix(step(text));
    }

    /// Lines without a half block are skipped.
    [[nodiscard]] raytracer::ByteImage picture() const {
        std::vector<std::vector<Cell>> drawn;
        std::ranges::copy_if(lines_, std::back_inserter(drawn),
                             [](const std::vector<Cell>& line) { return !line.empty(); });
        std::size_t width = 0;
        for (const std::vector<Cell>& line : drawn)
            width = std::max(width, line.size());
        raytracer::ByteImage picture{
            static_cast<int>(width), static_cast<int>(2 * drawn.size()), {}};
        for (const std::vector<Cell>& line : drawn)
            for (const bool upper : {true, false})
                for (std::size_t column = 0; column < width; ++column) {
                    const Cell cell = column < line.size() ? line[column] : Cell{};
                    for (const std::uint8_t byte : upper ? cell.upper : cell.lower)
                        picture.rgb.push_back(byte);
                }
        return picture;
    }

private:
    /// Interprets the next character or escape sequence; returns its length in bytes.
    std::size_t step(std::string_view text) {
        constexpr std::string_view kUpperHalfBlock = "\u2580";
        if (text.starts_with("\033[")) return escape(text);
        if (text.starts_with(kUpperHalfBlock)) {
            put({foreground_, background_});
            return kUpperHalfBlock.size();
        }
        if (text.front() == '\n') {
            ++line_;
            column_ = 0;  // a terminal turns it into carriage return and line feed
        } else if (text.front() == '\r') {
            column_ = 0;
        }
        return 1;
    }

    std::size_t escape(std::string_view text) {
        std::vector<int> numbers;
        std::size_t at = 2;
        for (; at < text.size() && !isLetter(text[at]); ++at) {
            if (text[at] == ';') continue;
            int number = 0;
            const auto end =
                std::from_chars(text.data() + at, text.data() + text.size(), number).ptr;
            numbers.push_back(number);
            at = std::max(at, static_cast<std::size_t>(end - text.data()) - 1);
        }
        if (at == text.size()) return at;
        if (text[at] == 'm') setColours(numbers);
        if (text[at] == 'A')
            line_ -= std::min(line_, numbers.empty() ? 1 : static_cast<std::size_t>(numbers[0]));
        if (text[at] == 'K' && line_ < lines_.size())
            lines_[line_].resize(std::min(column_, lines_[line_].size()));
        return at + 1;
    }

    static bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

    void setColours(const std::vector<int>& numbers) {
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (numbers[i] != 38 && numbers[i] != 48) continue;
            Colour& colour = numbers[i] == 38 ? foreground_ : background_;
            if (i + 2 < numbers.size() && numbers[i + 1] == 5) {
                colour = colourOf256(numbers[i + 2]);
                i += 2;
            } else if (i + 4 < numbers.size() && numbers[i + 1] == 2) {
                for (std::size_t channel = 0; channel < 3; ++channel)
                    colour[channel] = static_cast<std::uint8_t>(numbers[i + 2 + channel]);
                i += 4;
            }
        }
    }

    void put(const Cell& cell) {
        if (line_ >= lines_.size()) lines_.resize(line_ + 1);
        if (column_ >= lines_[line_].size()) lines_[line_].resize(column_ + 1);
        lines_[line_][column_++] = cell;
    }

    std::vector<std::vector<Cell>> lines_;
    std::size_t line_ = 0;
    std::size_t column_ = 0;
    Colour foreground_{};
    Colour background_{};
};

}  // namespace

raytracer::ByteImage terminalPicture(std::string_view written) {
    Screen screen;
    screen.write(written);
    return screen.picture();
}

raytracer::ByteImage enlarged(const raytracer::ByteImage& picture, int side) {
    raytracer::ByteImage large{picture.width * side, picture.height * side, {}};
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x) {
            const auto from = static_cast<std::ptrdiff_t>(3) *
                              (std::ptrdiff_t{y / side} * picture.width + x / side);
            large.rgb.insert(large.rgb.end(), picture.rgb.begin() + from,
                             picture.rgb.begin() + from + 3);
        }
    return large;
}

}  // namespace ticker
