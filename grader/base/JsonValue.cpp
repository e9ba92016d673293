#include <grader/base/JsonValue.h>

#include <grader/base/JsonLines.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <map>

namespace ticker {
namespace {

// Ordered: evidence stands in the order in which a person should read it.
using nlohmann::ordered_json;
using raytracer::InputError;

constexpr std::size_t kLongestFound = 60;

// Far beyond any of our files: the deepest has 11 levels, the largest object 37 members.
constexpr std::size_t kDeepest = 100;
constexpr std::size_t kMostMembers = 1000;

/// Refuses deep nesting and objects with many members: the parser's time grows with the square of
/// the number of members, so that a hostile text could keep it busy.
void refuseExcess(std::string_view text, const std::string& name) {
    std::vector<std::size_t> members;  // of each object and array that is open
    bool isInString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const auto refuse = [&](const std::string& what) {
            throw InputError(name, lineOfByte(text, i + 1), what);
        };
        if (isInString && c == '\\')
            ++i;
        else if (c == '"')
            isInString = !isInString;
        else if (isInString)
            continue;
        else if (c == '{' || c == '[')
            members.push_back(0);
        else if ((c == '}' || c == ']') && !members.empty())
            members.pop_back();
        else if (c == ':' && !members.empty() && ++members.back() > kMostMembers)
            refuse(fmt::format("expected at most {} members in an object", kMostMembers));
        if (members.size() > kDeepest)
            refuse(
                fmt::format("expected at most {} objects and arrays inside each other", kDeepest));
    }
}

/// The line of a number that is larger than any double. The parser's message quotes it.
int lineOfNumber(std::string_view text, std::string_view said) {
    const std::size_t quote = said.find('\'');
    if (quote == std::string_view::npos) return 0;
    const std::string_view number = said.substr(quote + 1, said.rfind('\'') - quote - 1);
    return lineOfByte(text, text.find(number) + 1);
}

const ordered_json& jsonOf(const void* value) {
    return *static_cast<const ordered_json*>(value);
}

}  // namespace

struct JsonValue::Document {
    std::string text;
    std::string name;
    JsonWords words;
    ordered_json root;
};

JsonValue::JsonValue(std::shared_ptr<const Document> document, std::string place, const void* value)
    : document_(std::move(document)), place_(std::move(place)), value_(value) {}

JsonValue JsonValue::parse(std::string text, std::string name, JsonWords words) {
    auto document =
        std::make_shared<Document>(Document{std::move(text), std::move(name), words, {}});
    refuseExcess(document->text, document->name);
    try {
        document->root = ordered_json::parse(document->text);
    } catch (const ordered_json::parse_error& error) {
        throw InputError(document->name, lineOfByte(document->text, error.byte),
                         fmt::format("not JSON: {}", error.what()));
    } catch (const ordered_json::out_of_range& error) {
        throw InputError(document->name, lineOfNumber(document->text, error.what()),
                         "a number is too large");
    }
    const void* const root = &document->root;
    return {std::move(document), "", root};
}

void JsonValue::refuse(const std::string& why) const {
    throw InputError(document_->name, jsonLineOf(document_->text, place_),
                     fmt::format("{}: {}", place_.empty() ? document_->words.whole : place_, why));
}

void JsonValue::expect(const std::string& what) const {
    std::string why = "expected " + what;
    if (document_->words.showsFound)
        why += ", found " + nlohmann::json(jsonOf(value_)).dump().substr(0, kLongestFound);
    refuse(why);
}

void JsonValue::allowOnly(std::span<const std::string_view> names) const {
    const auto found = members();
    for (const auto& [name, value] : std::map(found.begin(), found.end()))
        if (std::ranges::find(names, name) == names.end())
            value.refuse("expected no member of this name" +
                         raytracer::knownNamesHint(name, names));
}

bool JsonValue::has(const std::string& name) const {
    return isObject() && jsonOf(value_).contains(name);
}

JsonValue JsonValue::at(const std::string& name) const {
    if (!has(name)) expect(fmt::format("{} \"{}\"", document_->words.needs, name));
    return {document_, place_ + "/" + name, &jsonOf(value_).at(name)};
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members() const {
    if (!isObject()) expect("an object");
    std::vector<std::pair<std::string, JsonValue>> members;
    for (const auto& [name, value] : jsonOf(value_).items())
        members.emplace_back(name, JsonValue{document_, place_ + "/" + name, &value});
    return members;
}

std::vector<JsonValue> JsonValue::items() const {
    if (!isArray()) expect("an array");
    std::vector<JsonValue> items;
    for (const ordered_json& value : jsonOf(value_))
        items.push_back({document_, place_ + "/" + std::to_string(items.size()), &value});
    return items;
}

bool JsonValue::isNull() const {
    return jsonOf(value_).is_null();
}

bool JsonValue::isObject() const {
    return jsonOf(value_).is_object();
}

bool JsonValue::isArray() const {
    return jsonOf(value_).is_array();
}

std::optional<std::string> JsonValue::asText() const {
    if (!jsonOf(value_).is_string()) return std::nullopt;
    return jsonOf(value_).get<std::string>();
}

std::optional<double> JsonValue::asNumber() const {
    if (!jsonOf(value_).is_number()) return std::nullopt;
    return jsonOf(value_).get<double>();
}

std::optional<bool> JsonValue::asFlag() const {
    if (!jsonOf(value_).is_boolean()) return std::nullopt;
    return jsonOf(value_).get<bool>();
}

std::string JsonValue::text() const {
    auto text = asText();
    if (!text) expect("a string");
    return std::move(*text);
}

double JsonValue::number() const {
    const auto number = asNumber();
    if (!number) expect("a number");
    return *number;
}

bool JsonValue::flag() const {
    const auto flag = asFlag();
    if (!flag) expect("true or false");
    return *flag;
}

}  // namespace ticker
