#ifndef RAYTRACER_APP_VIEW_JSON_H
#define RAYTRACER_APP_VIEW_JSON_H

#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Vector3.h>

#include <string>
#include <string_view>

namespace raytracer::view {

// Values as JSON. The page gets nothing but ASCII and what was UTF-8 already.

[[nodiscard]] std::string json(std::string_view text);
[[nodiscard]] std::string json(double value);  ///< six digits; null where it is not finite
[[nodiscard]] std::string json(const Vector3& vector);
[[nodiscard]] std::string json(const ColourRGB& colour);  ///< "#RRGGBB", linear

/// Members of an object, in the order in which they are added.
class Members {
public:
    /// @param value  JSON.
    Members& add(std::string_view name, const std::string& value);
    [[nodiscard]] std::string object() const { return "{" + text_ + "}"; }

private:
    std::string text_;
};

/// Items of an array.
class Items {
public:
    void add(const std::string& value);
    [[nodiscard]] std::string array() const { return "[" + text_ + "]"; }

private:
    std::string text_;
};

/// Bytes in base64.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace raytracer::view

#endif
