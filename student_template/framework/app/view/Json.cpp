#include "Json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace raytracer::view {

std::string json(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (c == '\n') {
            quoted += "\\n";
        } else if (byte < 0x20 || byte == 0x7F) {
            std::array<char, 8> code{};
            std::snprintf(code.data(), code.size(), "\\u%04x", static_cast<unsigned>(byte));
            quoted += code.data();
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

std::string json(double value) {
    if (!std::isfinite(value)) return "null";
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

std::string json(const Vector3& vector) {
    return "[" + json(vector.x) + "," + json(vector.y) + "," + json(vector.z) + "]";
}

std::string json(const ColourRGB& colour) {
    const auto byte = [](double component) {
        return static_cast<unsigned>(std::lround(255.0 * std::clamp(component, 0.0, 1.0)));
    };
    std::array<char, 12> text{};
    std::snprintf(text.data(), text.size(), "\"#%02x%02x%02x\"", byte(colour.r), byte(colour.g),
                  byte(colour.b));
    return text.data();
}

Members& Members::add(std::string_view name, const std::string& value) {
    if (!text_.empty()) text_ += ',';
    text_ += json(name) + ":" + value;
    return *this;
}

void Items::add(const std::string& value) {
    if (!text_.empty()) text_ += ',';
    text_ += value;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8U |
                    (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : kDigits[group >> (18U - 6U * k) & 63U];
    }
    return text;
}

}  // namespace raytracer::view
