#ifndef TICKER_REPAIR_CANDIDATES_SCHEMA_H
#define TICKER_REPAIR_CANDIDATES_SCHEMA_H

#include <grader/repair/candidates/Atom.h>

#include <string>
#include <vector>

namespace ticker::candidates {

/// All edits in one program: at each site a switch, set at run time, chooses the edited text or the
/// one that was handed in.
struct Schema {
    /// Where an edit's switch stands in the program's text: from the switch to the end of the
    /// edited text.
    struct Place {
        std::size_t atom = 0;
        Range range;
    };
    std::string text;
    std::vector<Place> places;
};

/// @param atoms  Those that are apart have no switch.
[[nodiscard]] Schema makeSchema(const Tree& tree, const Source& source,
                                const std::vector<Atom>& atoms);

/// Edits that can be switched: parses the program, and moves a switch to the whole expression, or
/// marks the edit as apart, where types do not fit. Edits that no type allows are removed.
/// @return  The program of those that are left.
[[nodiscard]] Schema fitSchema(const Parser& parser, const std::string& file, const Tree& tree,
                               const Source& source, std::vector<Atom>& atoms);

}  // namespace ticker::candidates

#endif
