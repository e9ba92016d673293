#include <grader/intake/CanvasName.h>

#include <cstddef>

namespace ticker::intake {
namespace {

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kLate = "_late";
constexpr std::size_t kFewestAttachmentDigits = 5;

/// Removes the text up to the next underscore and returns it; empty without an underscore.
std::string_view cutWord(std::string_view& rest) {
    const std::size_t end = rest.find('_');
    if (end == std::string_view::npos) return {};
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    return word;
}

bool isId(std::string_view word) {
    return !word.empty() && word.front() != '0' &&
           word.find_first_not_of(kDigits) == std::string_view::npos;
}

// Canvas reduces a person's name to lower-case letters without accents, and digits.
bool mayBePerson(std::string_view name) {
    return !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") ==
                                std::string_view::npos;
}

}  // namespace

std::optional<CanvasName> readCanvasName(std::string_view name) {
    if (name.find('/') != std::string_view::npos) return std::nullopt;
    std::string_view rest = name;
    // The person's name, perhaps with underscores, goes to the first id behind its first word.
    std::string person{cutWord(rest)};
    std::string_view user = cutWord(rest);
    for (; !user.empty() && !isId(user); user = cutWord(rest))
        person += "_" + std::string{user};
    const std::string_view attachment = cutWord(rest);
    if (!isId(user) || !isId(attachment) || attachment.size() < kFewestAttachmentDigits ||
        rest.find('.') == std::string_view::npos)
        return std::nullopt;
    if (person.ends_with(kLate)) person.resize(person.size() - kLate.size());
    if (!mayBePerson(person)) return std::nullopt;
    return CanvasName{person + "_" + std::string{user}, std::string{rest}};
}

}  // namespace ticker::intake
