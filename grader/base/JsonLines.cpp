#include <grader/base/JsonLines.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <vector>

namespace ticker {
namespace {

using nlohmann::json;

/// Follows a parser through a text and keeps the line of one place.
class Follower {
public:
    Follower(const std::string& text, std::string_view wanted)
        : text_(text), stream_(text), wanted_(wanted) {}

    int lineOfWanted() {
        const auto follow = [this](int /*depth*/, json::parse_event_t event, json& parsed) {
            take(event, parsed);
            return true;
        };
        [[maybe_unused]] const json whole =
            json::parse(stream_, follow, /*allow_exceptions=*/false);
        return line_;
    }

private:
    struct Level {
        bool isArray = false;
        std::size_t items = 0;
        std::string name;  ///< of the member or item that is being read
    };

    void take(json::parse_event_t event, const json& parsed) {
        using Event = json::parse_event_t;
        const bool ends = event == Event::object_end || event == Event::array_end;
        if (ends) return levels_.pop_back();
        if (event == Event::key)
            levels_.back().name = parsed.get<std::string>();
        else if (!levels_.empty() && levels_.back().isArray)
            levels_.back().name = std::to_string(levels_.back().items++);
        // A member is found at its key, which its value must not overwrite.
        const bool isNew = event == Event::key || levels_.empty() || levels_.back().isArray;
        if (isNew && place() == wanted_) line_ = lineOfByte(text_, bytesRead());
        if (event == Event::object_start || event == Event::array_start)
            levels_.push_back({event == Event::array_start, 0, {}});
    }

    [[nodiscard]] std::string place() const {
        std::string place;
        for (const Level& level : levels_)
            place += "/" + level.name;
        return place;
    }

    [[nodiscard]] std::size_t bytesRead() {
        const auto read = stream_.rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in);
        return static_cast<std::size_t>(std::max<std::streamoff>(read, 1));
    }

    const std::string& text_;
    std::istringstream stream_;
    std::string_view wanted_;
    std::vector<Level> levels_;
    int line_ = 0;
};

}  // namespace

int jsonLineOf(const std::string& text, std::string_view place) {
    return Follower{text, place}.lineOfWanted();
}

int lineOfByte(std::string_view text, std::size_t byte) {
    const std::size_t before = std::min(byte > 0 ? byte - 1 : 0, text.size());
    return 1 + static_cast<int>(std::ranges::count(text.substr(0, before), '\n'));
}

}  // namespace ticker
