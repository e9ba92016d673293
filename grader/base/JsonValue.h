#ifndef TICKER_BASE_JSONVALUE_H
#define TICKER_BASE_JSONVALUE_H

#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ticker {

/// The words of the messages about one kind of file.
struct JsonWords {
    std::string_view whole = "the file";                 ///< the place of the whole text
    std::string_view needs = "an object with a member";  ///< before the name of a missing member
    bool showsFound = false;  ///< whether "expected ..." also says what was found
};

/// A value of a JSON text that knows its place. Every error is a raytracer::InputError that names
/// the file, the line, the place ("/options/0/name") and what was expected there.
class JsonValue {
public:
    /// @param name  The file, for messages.
    /// @throws raytracer::InputError if it is not JSON, or nests deeper or has larger objects than
    ///         any of our files.
    [[nodiscard]] static JsonValue parse(std::string text, std::string name, JsonWords words = {});

    /// Throws "PLACE: why".
    [[noreturn]] void refuse(const std::string& why) const;
    /// Throws "PLACE: expected what".
    [[noreturn]] void expect(const std::string& what) const;
    /// Refuses a member that is not among `names`, with the nearest name.
    void allowOnly(std::span<const std::string_view> names) const;
    void allowOnly(std::initializer_list<std::string_view> names) const {
        allowOnly(std::span{names.begin(), names.size()});
    }

    [[nodiscard]] bool has(const std::string& name) const;
    /// A member that must be there.
    [[nodiscard]] JsonValue at(const std::string& name) const;
    /// The members of an object, in the order of the file.
    [[nodiscard]] std::vector<std::pair<std::string, JsonValue>> members() const;
    /// The values of an array.
    [[nodiscard]] std::vector<JsonValue> items() const;

    [[nodiscard]] bool isNull() const;
    [[nodiscard]] bool isArray() const;
    [[nodiscard]] bool isObject() const;
    /// Each is empty where the value is of another type.
    [[nodiscard]] std::optional<std::string> asText() const;
    [[nodiscard]] std::optional<double> asNumber() const;
    [[nodiscard]] std::optional<bool> asFlag() const;
    /// Each refuses a value of another type.
    [[nodiscard]] std::string text() const;
    [[nodiscard]] double number() const;
    [[nodiscard]] bool flag() const;

private:
    struct Document;
    JsonValue(std::shared_ptr<const Document> document, std::string place, const void* value);

    std::shared_ptr<const Document> document_;
    std::string place_;
    const void* value_;  ///< nlohmann's value, which only the source file names
};

}  // namespace ticker

#endif
