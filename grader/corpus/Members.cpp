#include <grader/corpus/Members.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace ticker::corpus {

using nlohmann::json;

Members::Members(const json& object, std::string path, std::string where)
    : object_(object), path_(std::move(path)), where_(std::move(where)) {
    if (!object_.is_object()) fail("must be an object");
}

const json& Members::required(const std::string& name) {
    known_.insert(name);
    if (!object_.contains(name)) fail(fmt::format("needs \"{}\"", name));
    return object_.at(name);
}

const json& Members::array(const std::string& name) {
    const json& value = required(name);
    if (!value.is_array()) fail(fmt::format("\"{}\" must be an array", name));
    return value;
}

std::string Members::string(const std::string& name) {
    const json& value = required(name);
    if (!value.is_string()) fail(fmt::format("\"{}\" must be a string", name));
    return value.get<std::string>();
}

std::string Members::plainName(const std::string& name) {
    std::string value = string(name);
    if (value.find('/') != std::string::npos)
        fail(fmt::format("\"{}\" must be a plain name", name));
    return value;
}

std::vector<std::string> Members::strings(const std::string& name) {
    const json& value = array(name);
    if (!std::all_of(value.begin(), value.end(), [](const json& each) { return each.is_string(); }))
        fail(fmt::format("\"{}\" must hold strings only", name));
    return value.get<std::vector<std::string>>();
}

std::vector<std::string> Members::choices(const std::string& name,
                                          std::span<const std::string_view> known) {
    const bool isOne = required(name).is_string();
    std::vector<std::string> values =
        isOne ? std::vector<std::string>{string(name)} : strings(name);
    if (values.empty()) fail(fmt::format("\"{}\" is empty", name));
    for (const std::string& value : values)
        if (std::find(known.begin(), known.end(), value) == known.end())
            fail(fmt::format("\"{}\" does not know \"{}\"", name, value));
    return values;
}

std::string Members::text(const std::string& name) {
    const json& value = required(name);
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_array() || value.empty())
        fail(fmt::format("\"{}\" must be a string or an array of lines", name));
    return fmt::format("{}", fmt::join(strings(name), "\n"));
}

std::string Members::bytes(const std::string& name) {
    const std::string digits = string(name);
    std::string bytes;
    for (std::size_t at = 0; at + 1 < digits.size(); at += 2) {
        const auto isDigit = [&](char c) {
            return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
        };
        if (!isDigit(digits[at]) || !isDigit(digits[at + 1]))
            fail(fmt::format("\"{}\" is not hexadecimal", name));
        bytes.push_back(static_cast<char>(std::stoi(digits.substr(at, 2), nullptr, 16)));
    }
    return bytes;
}

unsigned long Members::count(const std::string& name) {
    const json& value = required(name);
    if (!value.is_number_unsigned()) fail(fmt::format("\"{}\" must be a count", name));
    return value.get<unsigned long>();
}

bool Members::flag(const std::string& name) {
    if (!object_.contains(name)) return false;
    const json& value = required(name);
    if (!value.is_boolean()) fail(fmt::format("\"{}\" must be true or false", name));
    return value.get<bool>();
}

void Members::finish() const {
    for (const auto& [name, value] : object_.items())
        if (known_.count(name) == 0) fail(fmt::format("does not know \"{}\"", name));
}

void Members::fail(const std::string& message) const {
    throw raytracer::InputError(path_, 0, where_ + " " + message);
}

}  // namespace ticker::corpus
