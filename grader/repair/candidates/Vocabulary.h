#ifndef TICKER_REPAIR_CANDIDATES_VOCABULARY_H
#define TICKER_REPAIR_CANDIDATES_VOCABULARY_H

#include <grader/repair/candidates/Atom.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ticker::candidates {

/// What a node's function could name.
class Vocabulary {
public:
    Vocabulary(const Edits& edits, int index);

    /// Variables of a type, the nearest first; at most five.
    [[nodiscard]] std::vector<std::string> variables(std::string_view type) const;
    /// Pairs of numbers that were computed alike, such as two roots.
    [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& twins() const {
        return twins_;
    }
    /// Variables of a type that no expression of the function names.
    [[nodiscard]] std::vector<std::string> idle(std::string_view type) const;
    /// Variables that hold an angle: an inverse function of trigonometry gave them.
    [[nodiscard]] const std::vector<std::string>& angles() const { return angles_; }
    /// Quantities of a type that the function does not use yet.
    [[nodiscard]] std::vector<std::string> unused(std::string_view type) const;
    /// Variables and unused quantities, and what functions of one argument return for a variable.
    [[nodiscard]] std::vector<std::string> all(std::string_view type) const;
    /// Points and directions, used or not.
    [[nodiscard]] std::vector<std::string> places() const;
    /// The same, and what functions of one argument return for a variable.
    [[nodiscard]] std::vector<std::string> points() const;
    [[nodiscard]] std::vector<std::string> colours() const;
    /// Numbers of objects, such as a reflectivity, used or not.
    [[nodiscard]] const std::vector<std::string>& numbers() const { return numbers_; }
    /// Lengths of the variables that are vectors.
    [[nodiscard]] std::vector<std::string> lengths() const;
    /// Numbers of the kit's own, such as a bias, that the function does not use.
    [[nodiscard]] const std::vector<std::string>& constants() const { return constants_; }

    /// Calls of the functions of one argument that give this type.
    [[nodiscard]] std::vector<std::string> calls(std::string_view type) const;

    /// Functions of one argument that give this type, as they are called.
    [[nodiscard]] std::vector<std::string> functions(std::string_view type) const;

private:
    void addPart(const Quantity& part, std::string_view used);

    struct Variable {
        std::string name;
        std::string type;
        bool isIdle = false;
    };
    std::vector<Variable> variables_;
    std::vector<std::pair<std::string, std::string>> twins_;
    std::vector<std::string> angles_;
    std::vector<Quantity> unused_;
    std::vector<Quantity> methods_;
    std::vector<std::string> points_;
    std::vector<std::string> colours_;
    std::vector<std::string> numbers_;
    std::vector<std::string> constants_;
};

}  // namespace ticker::candidates

#endif
