#include <raytracer/base/Text.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <system_error>
#include <vector>

namespace raytracer {
namespace {

constexpr std::size_t kLongestQuote = 60;

char lowerCase(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Edit distance: letters to insert, delete or replace (Levenshtein 1966).
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced =
                diagonal + (lowerCase(a[i]) == lowerCase(b[j]) ? std::size_t{0} : std::size_t{1});
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::optional<double> parseNumber(std::string_view text) {
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('+') || text.starts_with('-')) return std::nullopt;
    }
    // strtod, since not every standard library has from_chars for double. It would also accept
    // hexadecimal numbers, "inf" and "nan", whose letters are refused here.
    if (text.empty() || text.find_first_not_of("0123456789.eE+-") != std::string_view::npos)
        return std::nullopt;
    const std::string whole{text};
    char* end = nullptr;
    errno = 0;
    const double value = std::strtod(whole.c_str(), &end);
    if (errno != 0 || end != whole.c_str() + whole.size()) return std::nullopt;
    return value;
}

std::optional<std::uint64_t> parseCount(std::string_view text) {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

std::string inQuotes(std::string_view text) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string result = "\"";
    for (const char c : text.substr(0, kLongestQuote)) {
        if (c >= ' ' && c <= '~') {
            result += c;
        } else {
            const auto byte = static_cast<unsigned char>(c);
            result += {'\\', 'x', kDigits[byte / 16U], kDigits[byte % 16U]};
        }
    }
    if (text.size() > kLongestQuote) result += "...";
    return result + "\"";
}

std::string joined(std::span<const std::string_view> names) {
    std::string result;
    for (const std::string_view name : names) {
        if (!result.empty()) result += ", ";
        result += name;
    }
    return result;
}

std::optional<std::string_view> nearestName(std::string_view name,
                                            std::span<const std::string_view> known) {
    if (known.empty() || name.size() > kLongestQuote) return std::nullopt;
    const auto nearest = std::min_element(
        known.begin(), known.end(), [name](std::string_view one, std::string_view other) {
            return editDistance(name, one) < editDistance(name, other);
        });
    const std::size_t allowed = std::max<std::size_t>(1, nearest->size() / 3);
    // A name of one letter is at distance one from every other such name: no basis for a guess.
    const bool guessable =
        name.size() > 1 || (name.size() == 1 && editDistance(name, *nearest) == 0);
    if (!guessable || editDistance(name, *nearest) > allowed) return std::nullopt;
    return *nearest;
}

std::string knownNamesHint(std::string_view name, std::span<const std::string_view> known) {
    const std::optional<std::string_view> nearest = nearestName(name, known);
    return (nearest ? "; did you mean " + inQuotes(*nearest) + "? Known are: " : "; known are: ") +
           joined(known);
}

}  // namespace raytracer
