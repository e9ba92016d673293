#ifndef RAYTRACER_SRC_IO_ATTRIBUTES_H
#define RAYTRACER_SRC_IO_ATTRIBUTES_H

#include "Xml.h"

#include <raytracer/image/ColourRGB.h>

#include <span>
#include <string>
#include <string_view>

namespace raytracer {

/// The permitted range of a number; `text` describes it in error messages.
struct NumberRange {
    double low;
    double high;
    bool lowIsAllowed;
    std::string_view text;
};

/// Bound for all coordinates and sizes; squares and products of such numbers stay finite.
inline constexpr double kLargestNumber = 1e9;
inline constexpr NumberRange kAnyNumber{-kLargestNumber, kLargestNumber, true,
                                        "a number from -1e9 to 1e9"};
inline constexpr NumberRange kNotNegative{0.0, kLargestNumber, true, "a number from 0 to 1e9"};
inline constexpr NumberRange kPositive{0.0, kLargestNumber, false, "a number above 0, up to 1e9"};
inline constexpr NumberRange kShare{0.0, 1.0, true, "a number from 0 to 1"};

/// The attributes of one element, checked as they are read.
class Attributes {
public:
    /// @throws InputError if the element has an attribute that is not in `known`, or has children.
    Attributes(std::string file, const XmlElement& element,
               std::span<const std::string_view> known);

    /// @throws InputError if the attribute is present but is not a number in `range`.
    [[nodiscard]] double number(std::string_view name, double fallback,
                                const NumberRange& range) const;

    /// The attribute `colour`, #RRGGBB; a byte of 255 gives 1.
    /// @throws InputError if it is missing or malformed.
    [[nodiscard]] ColourRGB colour() const;

    /// @throws InputError if it is missing.
    [[nodiscard]] const XmlAttribute& required(std::string_view name) const;

    /// Throws an InputError with the line of the element.
    [[noreturn]] void fail(const std::string& message) const;
    /// Throws an InputError with the line of one attribute.
    [[noreturn]] void fail(const XmlAttribute& attribute, const std::string& expected) const;

private:
    [[nodiscard]] const XmlAttribute* find(std::string_view name) const;

    std::string file_;
    const XmlElement& element_;
};

}  // namespace raytracer

#endif
