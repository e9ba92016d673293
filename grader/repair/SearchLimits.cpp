#include <grader/repair/SearchLimits.h>

#include <grader/base/JsonValue.h>

#include <fmt/format.h>

namespace ticker::repair {

// Made from limits.json by CMake.
extern const char* const kDefaultLimitsText;

namespace {

double numberIn(const JsonValue& object, const char* field, double least, double most) {
    const JsonValue value = object.at(field);
    const auto number = value.asNumber();
    if (!number || !(*number >= least && *number <= most))
        value.expect(fmt::format("a number from {} to {}", least, most));
    return *number;
}

}  // namespace

SearchLimits parseSearchLimits(const std::string& text, const std::string& name) {
    const JsonValue top = JsonValue::parse(text, name);
    top.allowOnly({"cpuSeconds", "wallSeconds", "untilShare"});
    SearchLimits limits;
    limits.all.cpuSeconds = numberIn(top, "cpuSeconds", 1, 3600);
    limits.all.wallSeconds = numberIn(top, "wallSeconds", limits.all.cpuSeconds, 10'800);
    const JsonValue shares = top.at("untilShare");
    shares.allowOnly({"singles", "twins", "wide", "pairs", "twoMistakes"});
    limits.singles = numberIn(shares, "singles", 0, 1);
    limits.twins = numberIn(shares, "twins", limits.singles, 1);
    limits.wide = numberIn(shares, "wide", limits.twins, 1);
    limits.pairs = numberIn(shares, "pairs", limits.wide, 1);
    limits.twoMistakes = numberIn(shares, "twoMistakes", limits.pairs, 1);
    return limits;
}

const SearchLimits& defaultSearchLimits() {
    static const SearchLimits limits = parseSearchLimits(kDefaultLimitsText, "limits.json");
    return limits;
}

}  // namespace ticker::repair
