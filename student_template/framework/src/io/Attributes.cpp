#include "Attributes.h"

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

namespace raytracer {
namespace {

std::optional<std::uint32_t> parseHexadecimal(std::string_view digits) {
    std::uint32_t value = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value, 16);
    return error == std::errc{} && stop == end ? std::optional{value} : std::nullopt;
}

bool contains(const NumberRange& range, double value) {
    return value <= range.high && (range.lowIsAllowed ? value >= range.low : value > range.low);
}

}  // namespace

Attributes::Attributes(std::string file, const XmlElement& element,
                       std::span<const std::string_view> known)
    : file_(std::move(file)), element_(element) {
    if (!element.children.empty())
        throw InputError(file_, element.children.front().line,
                         "found " + inQuotes(element.children.front().name) + " inside <" +
                             element.name + ">, which holds no elements; close it with />");
    for (const XmlAttribute& attribute : element.attributes)
        if (std::find(known.begin(), known.end(), attribute.name) == known.end())
            throw InputError(file_, attribute.line,
                             "unknown attribute " + inQuotes(attribute.name) + " in <" +
                                 element.name + ">" + knownNamesHint(attribute.name, known));
}

double Attributes::number(std::string_view name, double fallback, const NumberRange& range) const {
    const XmlAttribute* attribute = find(name);
    if (attribute == nullptr) return fallback;
    const std::optional<double> value = parseNumber(attribute->value);
    if (!value || !contains(range, *value)) fail(*attribute, std::string(range.text));
    return *value;
}

ColourRGB Attributes::colour() const {
    const XmlAttribute& attribute = required("colour");
    const std::string_view text = attribute.value;
    const std::optional<std::uint32_t> packed =
        text.size() == 7 && text.starts_with('#') ? parseHexadecimal(text.substr(1)) : std::nullopt;
    if (!packed) fail(attribute, "#RRGGBB, six hexadecimal digits, as in #F45B00");
    const auto channel = [&packed](unsigned shift) { return (*packed >> shift & 0xFFU) / 255.0; };
    return {channel(16), channel(8), channel(0)};
}

const XmlAttribute& Attributes::required(std::string_view name) const {
    const XmlAttribute* attribute = find(name);
    if (attribute == nullptr)
        fail("<" + element_.name + "> has no " + inQuotes(name) + "; it is required");
    return *attribute;
}

void Attributes::fail(const std::string& message) const {
    throw InputError(file_, element_.line, message);
}

void Attributes::fail(const XmlAttribute& attribute, const std::string& expected) const {
    throw InputError(file_, attribute.line,
                     attribute.name + "=" + inQuotes(attribute.value) + " in <" + element_.name +
                         ">; expected " + expected);
}

const XmlAttribute* Attributes::find(std::string_view name) const {
    const auto found =
        std::find_if(element_.attributes.begin(), element_.attributes.end(),
                     [name](const XmlAttribute& attribute) { return attribute.name == name; });
    return found == element_.attributes.end() ? nullptr : &*found;
}

}  // namespace raytracer
