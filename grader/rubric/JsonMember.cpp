#include <grader/rubric/JsonMember.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <algorithm>
#include <fstream>

namespace ticker::rubric {

using nlohmann::json;
using raytracer::InputError;

json readJson(const std::filesystem::path& file, const std::string& what) {
    std::ifstream stream{file};
    if (!stream) throw InputError(file.string(), 0, "cannot be read; expected " + what);
    try {
        return json::parse(stream);
    } catch (const json::exception& error) {
        throw InputError(file.string(), 0, fmt::format("not JSON: {}", error.what()));
    }
}

void JsonMember::fail(const std::string& expected) const {
    throw InputError(
        file_, 0,
        fmt::format("{}: expected {}, found {}", place_.empty() ? "the whole file" : place_,
                    expected, value_.dump().substr(0, 60)));
}

void JsonMember::expectOnly(std::initializer_list<const char*> names) const {
    if (!value_.is_object()) fail("an object");
    for (const auto& [name, unused] : value_.items())
        if (std::find(names.begin(), names.end(), name) == names.end())
            JsonMember{file_, place_ + "/" + name, value_}.fail("no member of this name");
}

JsonMember JsonMember::at(const std::string& name) const {
    if (!value_.contains(name)) fail("a member \"" + name + "\"");
    return {file_, place_ + "/" + name, value_.at(name)};
}

std::vector<JsonMember> JsonMember::items() const {
    if (!value_.is_array() || value_.empty()) fail("an array that is not empty");
    std::vector<JsonMember> members;
    for (std::size_t i = 0; i < value_.size(); ++i)
        members.push_back({file_, place_ + "/" + std::to_string(i), value_[i]});
    return members;
}

std::string JsonMember::text() const {
    if (!value_.is_string()) fail("a string");
    return value_.get<std::string>();
}

bool JsonMember::yesOrNo() const {
    if (!value_.is_boolean()) fail("true or false");
    return value_.get<bool>();
}

double JsonMember::number(double atLeast) const {
    if (!value_.is_number() || !(value_.get<double>() >= atLeast))
        fail(fmt::format("a number of at least {}", atLeast));
    return value_.get<double>();
}

}  // namespace ticker::rubric
