#ifndef TICKER_REPAIR_EDITSETS_H
#define TICKER_REPAIR_EDITSETS_H

#include <grader/repair/Candidates.h>
#include <grader/repair/SwitchedProgram.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace ticker::repair {

/// All text edits of a set, in the order of the file.
[[nodiscard]] std::vector<TextEdit> textEdits(const Candidates& candidates, const EditSet& set);

/// True for the edits that take part. Those in functions that solve only other tasks do not.
using Choice = std::function<bool(const Atom&)>;

// Sets of edits, those that change the fewest tokens first.

/// Each edit that has a switch by itself.
[[nodiscard]] std::vector<EditSet> singles(std::string_view source, const Candidates& candidates,
                                           const Choice& isChosen);

/// The same for light edits only: those of operators, signs, numbers, names and the like.
[[nodiscard]] std::vector<EditSet> lightSingles(std::string_view source,
                                                const Candidates& candidates,
                                                const Choice& isChosen);

/// Each edit that has to be compiled by itself, such as a variable that is no longer static.
[[nodiscard]] std::vector<EditSet> withoutSwitch(const Candidates& candidates,
                                                 const Choice& isChosen);

/// The same edit at places that correspond: in x and in y, along u and along v, in two calls.
[[nodiscard]] std::vector<EditSet> twins(std::string_view source, const Candidates& candidates,
                                         const Choice& isChosen);

/// Two small edits of one statement.
[[nodiscard]] std::vector<EditSet> pairs(std::string_view source, const Candidates& candidates,
                                         const Choice& isChosen);

/// Two changed signs in different statements, such as those of a reversed direction and of a term
/// with it; or two statements left out, such as leftovers of an experiment.
[[nodiscard]] std::vector<EditSet> linked(std::string_view source, const Candidates& candidates,
                                          const Choice& isChosen);

/// The union of a set with each of the others that changes other text.
[[nodiscard]] std::vector<EditSet> together(const Candidates& candidates, const EditSet& set,
                                            std::span<const EditSet> others);

}  // namespace ticker::repair

#endif
