#ifndef TICKER_RUBRIC_JSONMEMBER_H
#define TICKER_RUBRIC_JSONMEMBER_H

#include <nlohmann/json.hpp>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

namespace ticker::rubric {

/// Reads a whole policy file.
/// @param what  What it should be, for messages: "a rubric".
/// @throws raytracer::InputError where it cannot be read or is no JSON.
[[nodiscard]] nlohmann::json readJson(const std::filesystem::path& file, const std::string& what);

/// Reads members of one JSON object and says where it is in the file when one does not fit.
class JsonMember {
public:
    /// @param value  Outlives the reader.
    JsonMember(std::string file, std::string place, const nlohmann::json& value)
        : file_(std::move(file)), place_(std::move(place)), value_(value) {}

    /// @throws raytracer::InputError always: names file, place, and what was expected.
    [[noreturn]] void fail(const std::string& expected) const;

    // All of these throw raytracer::InputError where the value is of another kind.
    void expectOnly(std::initializer_list<const char*> names) const;
    [[nodiscard]] JsonMember at(const std::string& name) const;
    [[nodiscard]] std::vector<JsonMember> items() const;
    [[nodiscard]] std::string text() const;
    [[nodiscard]] bool yesOrNo() const;
    [[nodiscard]] double number(double atLeast) const;

    [[nodiscard]] const nlohmann::json& value() const { return value_; }

private:
    std::string file_;
    std::string place_;
    const nlohmann::json& value_;
};

}  // namespace ticker::rubric

#endif
