#include <grader/repair/SearchLimits.h>

#include <grader/base/JsonValue.h>
#include <grader/repair/DefaultLimits.h>

namespace ticker::repair {
namespace {

double secondsIn(const JsonValue& object, const char* field, double least) {
    const double seconds = object.at(field).number();
    constexpr double kMost = 3600.0;
    if (!(seconds >= least && seconds <= kMost))
        object.at(field).expect(
            "a number from 1 to 3600, for the wall no smaller than for the CPU");
    return seconds;
}

/// @param before  The share of the kind before it.
double shareIn(const JsonValue& object, const char* field, double before) {
    const double share = object.at(field).number();
    if (!(share >= before && share <= 1.0))
        object.at(field).expect("a number from 0 to 1, no smaller than the one before");
    return share;
}

}  // namespace

SearchLimits parseSearchLimits(const std::string& text, const std::string& name) {
    const JsonValue top = JsonValue::parse(text, name);
    top.allowOnly({"cpuSeconds", "wallSeconds", "untilShare"});
    SearchLimits limits;
    limits.all.cpuSeconds = secondsIn(top, "cpuSeconds", 1.0);
    limits.all.wallSeconds = secondsIn(top, "wallSeconds", limits.all.cpuSeconds);
    const JsonValue shares = top.at("untilShare");
    shares.allowOnly({"others", "singles", "formulas", "wide", "twins", "pairs", "twoMistakes"});
    limits.others = shareIn(shares, "others", 0);
    limits.singles = shareIn(shares, "singles", 0);
    limits.formulas = shareIn(shares, "formulas", limits.singles);
    limits.wide = shareIn(shares, "wide", limits.formulas);
    limits.twins = shareIn(shares, "twins", limits.wide);
    limits.pairs = shareIn(shares, "pairs", limits.twins);
    limits.twoMistakes = shareIn(shares, "twoMistakes", limits.pairs);
    return limits;
}

const SearchLimits& defaultSearchLimits() {
    static const SearchLimits limits = parseSearchLimits(kDefaultLimitsText, "limits.json");
    return limits;
}

}  // namespace ticker::repair
