#include <grader/base/JsonLines.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <sstream>
#include <vector>

namespace ticker {
namespace {

using nlohmann::json;

/// Finds the byte at which one place of a text stands, in time proportional to the text's length,
/// since texts may be hostile. nlohmann's parser callbacks would take longer: at the end of each
/// item they look at all earlier items of the array.
class Follower final : public json::json_sax_t {
public:
    Follower(const std::string& text, std::string_view wanted) : stream_(text), wanted_(wanted) {}

    /// Number of the byte, from 1; 0 if the text has no such place.
    std::size_t byteOfWanted() {
        json::sax_parse(stream_, this);
        return byte_;
    }

    bool null() override { return value(); }
    bool boolean(bool /*value*/) override { return value(); }
    bool number_integer(number_integer_t /*value*/) override { return value(); }
    bool number_unsigned(number_unsigned_t /*value*/) override { return value(); }
    bool number_float(number_float_t /*value*/, const string_t& /*text*/) override {
        return value();
    }
    bool string(string_t& /*value*/) override { return value(); }
    bool binary(binary_t& /*value*/) override { return value(); }
    bool start_object(std::size_t /*size*/) override { return open(false); }
    bool start_array(std::size_t /*size*/) override { return open(true); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override { return enter(name); }
    bool parse_error(std::size_t /*byte*/, const std::string& /*token*/,
                     const nlohmann::detail::exception& /*error*/) override {
        return false;
    }

private:
    /// How much of the wanted place, from its beginning, is the place of a value; empty: the wanted
    /// place does not go through it. The value's own place may be long in a hostile text.
    using Match = std::optional<std::size_t>;

    /// An open array or object.
    struct Level {
        bool isArray = false;
        Match match;
        std::size_t items = 0;
    };

    // A member was entered at its key already.
    bool value() {
        if (levels_.empty()) return note();
        if (!levels_.back().isArray) return true;
        return enter(std::to_string(levels_.back().items++));
    }

    bool open(bool isArray) {
        value();
        levels_.push_back({isArray, match_});
        return true;
    }

    bool close() {
        levels_.pop_back();
        return true;
    }

    /// Goes to a member or item of the innermost level.
    bool enter(std::string_view name) {
        const Match above = levels_.back().match;
        const std::string_view rest = above ? wanted_.substr(*above) : std::string_view{};
        const bool isOnTheWay = rest.starts_with('/') && rest.substr(1).starts_with(name);
        match_ = isOnTheWay ? Match{*above + 1 + name.size()} : std::nullopt;
        return note();
    }

    bool note() {
        if (match_ == wanted_.size()) byte_ = bytesRead();
        return true;
    }

    [[nodiscard]] std::size_t bytesRead() {
        const auto read = stream_.rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in);
        return static_cast<std::size_t>(std::max<std::streamoff>(read, 1));
    }

    std::istringstream stream_;
    std::string_view wanted_;
    std::vector<Level> levels_;
    Match match_ = 0;       ///< of the value that is being read, at first the whole text
    std::size_t byte_ = 0;  ///< of the wanted place, from 1
};

}  // namespace

int jsonLineOf(const std::string& text, std::string_view place) {
    const std::size_t byte = Follower{text, place}.byteOfWanted();
    return byte == 0 ? 0 : lineOfByte(text, byte);
}

int lineOfByte(std::string_view text, std::size_t byte) {
    const std::size_t before = std::min(byte > 0 ? byte - 1 : 0, text.size());
    return 1 + static_cast<int>(std::ranges::count(text.substr(0, before), '\n'));
}

}  // namespace ticker
