#ifndef TICKER_LAB_SIMILAR_DISGUISE_H
#define TICKER_LAB_SIMILAR_DISGUISE_H

#include <array>
#include <set>
#include <string>
#include <string_view>

namespace ticker::similar {

/// What is done to a copy so that it looks like own work.
enum class Disguise {
    names,        ///< every name is replaced, except those of the kit and the language
    order,        ///< neighbouring declarations and functions change places where they may
    comments,     ///< other comments, line breaks and indentation
    expressions,  ///< expressions and loops are written in another way
    parts         ///< the first half; the second one is another student's
};

inline constexpr std::array kDisguises{Disguise::names, Disguise::order, Disguise::comments,
                                       Disguise::expressions, Disguise::parts};

[[nodiscard]] std::string_view toString(Disguise disguise);

/// The identifiers of a C++ text.
[[nodiscard]] std::set<std::string> wordsOf(std::string_view source);

/// A copy of `source` in which edits of its text hide where it came from. It is not compiled.
/// @param known  Names that stay: those of the kit and of the language.
/// @param other  Another student's file, for `parts`.
[[nodiscard]] std::string disguised(Disguise disguise, const std::string& source,
                                    const std::set<std::string>& known, const std::string& other);

}  // namespace ticker::similar

#endif
