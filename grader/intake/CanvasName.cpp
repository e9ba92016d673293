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
    std::string_view word = cutWord(rest);
    std::size_t length = word.size();
    for (word = cutWord(rest); !word.empty() && !isId(word); word = cutWord(rest))
        length += 1 + word.size();
    std::string_view person = name.substr(0, length);
    const std::string_view attachment = cutWord(rest);
    if (!isId(word) || !isId(attachment) || attachment.size() < kFewestAttachmentDigits ||
        rest.find('.') == std::string_view::npos)
        return std::nullopt;
    if (person.ends_with(kLate)) person.remove_suffix(kLate.size());
    if (!mayBePerson(person)) return std::nullopt;
    return CanvasName{std::string{person} + "_" + std::string{word}, std::string{rest}};
}

}  // namespace ticker::intake
