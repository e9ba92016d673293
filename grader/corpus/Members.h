#ifndef TICKER_CORPUS_MEMBERS_H
#define TICKER_CORPUS_MEMBERS_H

#include <nlohmann/json.hpp>

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::corpus {

/// Reads the members of one JSON object and rejects unknown ones. Every function throws
/// raytracer::InputError with the file and `where` if a member has the wrong form.
class Members {
public:
    /// @param object  Must outlive this object.
    /// @param where   Describes the object: "the entry", "\"edits\"[0]".
    Members(const nlohmann::json& object, std::string path, std::string where);

    [[nodiscard]] bool has(const std::string& name) const { return object_.contains(name); }
    [[nodiscard]] const nlohmann::json& required(const std::string& name);
    [[nodiscard]] const nlohmann::json& array(const std::string& name);
    [[nodiscard]] std::string string(const std::string& name);
    /// A name without slashes.
    [[nodiscard]] std::string plainName(const std::string& name);
    [[nodiscard]] std::vector<std::string> strings(const std::string& name);
    /// A string or an array of strings, each one of `known`.
    [[nodiscard]] std::vector<std::string> choices(const std::string& name,
                                                   std::span<const std::string_view> known);
    /// A string, or an array of lines.
    [[nodiscard]] std::string text(const std::string& name);
    /// Bytes in lower-case hexadecimal digits.
    [[nodiscard]] std::string bytes(const std::string& name);
    [[nodiscard]] unsigned long count(const std::string& name);
    /// False if the member is missing.
    [[nodiscard]] bool flag(const std::string& name);

    /// Must be called last. Fails if a member was not read.
    void finish() const;
    [[noreturn]] void fail(const std::string& message) const;

private:
    const nlohmann::json& object_;
    std::string path_;
    std::string where_;
    std::set<std::string> known_;
};

}  // namespace ticker::corpus

#endif
