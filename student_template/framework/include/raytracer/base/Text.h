#ifndef RAYTRACER_BASE_TEXT_H
#define RAYTRACER_BASE_TEXT_H

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace raytracer {

/// The number that the whole of `text` spells: digits with an optional sign, fraction and exponent,
/// in every locale. Empty for anything else: spaces, units, hexadecimal digits, "nan", "inf", and
/// numbers that a double cannot hold.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

/// The non-negative whole number that the whole of `text` spells in decimal digits.
[[nodiscard]] std::optional<std::uint64_t> parseCount(std::string_view text);

/// `text` in quotation marks for a message: bytes other than printable ASCII become `\xNN`, and
/// everything beyond 60 bytes is cut.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// Joins `names`: "x, y, z".
[[nodiscard]] std::string joined(std::span<const std::string_view> names);

/// The most similar name of `known`; empty if none is similar. Similar means: at most a third of
/// the letters (at least one) added, left out or replaced; case does not count.
[[nodiscard]] std::optional<std::string_view> nearestName(std::string_view name,
                                                          std::span<const std::string_view> known);

/// The end of a message about an unknown name: "; did you mean "kD"? Known are: x, y, z".
[[nodiscard]] std::string knownNamesHint(std::string_view name,
                                         std::span<const std::string_view> known);

}  // namespace raytracer

#endif
