#ifndef TICKER_CORPUS_MEMBERS_H
#define TICKER_CORPUS_MEMBERS_H

#include <nlohmann/json.hpp>

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::corpus {

/// Reads the members of one JSON object and refuses those that were not asked for. Every function
/// throws raytracer::InputError with the file and `where` if a member is not as it must be.
class Members {
public:
    /// @param object  Must outlive this object.
    /// @param where   What the object is: "the entry", "\"edits\"[0]".
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
    /// Bytes in small hexadecimal digits.
    [[nodiscard]] std::string bytes(const std::string& name);
    [[nodiscard]] unsigned long count(const std::string& name);
    /// False where it is not there.
    [[nodiscard]] bool flag(const std::string& name);

    /// To be called last: fails where a member is left.
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
