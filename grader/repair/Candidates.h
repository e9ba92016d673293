#ifndef TICKER_REPAIR_CANDIDATES_H
#define TICKER_REPAIR_CANDIDATES_H

#include <grader/build/Kit.h>
#include <grader/exercise/Exercise.h>
#include <grader/sandbox/Sandbox.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::repair {

/// Bytes of a file, and what stands there instead.
struct TextEdit {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string text;

    [[nodiscard]] bool operator==(const TextEdit&) const = default;
};

/// One small edit of a submission.
struct Atom {
    std::string kind;                ///< "operator", "sign", ...
    std::string function;            ///< name of the outermost function that it stands in
    std::vector<TextEdit> edits;     ///< in the order of the file
    std::size_t statementBegin = 0;  ///< bytes of the statement that they stand in
    std::size_t statementEnd = 0;
    std::size_t siteBegin = 0;  ///< bytes that its switch replaces, with all other switches in them
    std::size_t siteEnd = 0;
    bool isApart = false;  ///< has no switch in `Candidates::program`
};

/// Which edits are looked for.
enum class Reach {
    simple,  ///< of tokens, and with what stands near
    wide     ///< with everything that the function could name
};

/// What is looked for in a file.
struct Wanted {
    Reach reach = Reach::simple;
    std::string leftAlone = {};          ///< functions that are not edited, with commas in between
    std::vector<Formula> formulas = {};  ///< of the handout, for wide edits
};

/// The kind of an edit that puts in a formula of the handout.
inline constexpr std::string_view kFormulaKind = "formula";

/// The edits that were found for a file.
struct Candidates {
    std::string program;  ///< the file with a switch for each edit: that of atoms[i] has number i
    std::vector<Atom> atoms;
    bool keepsState = false;  ///< what one question leaves behind may change the next answer
    double cpuMs = 0.0;
};

/// Parses a file in the sandbox and finds small edits of it.
/// @return  The program is empty where the file cannot be parsed within the limits.
/// @throws raytracer::Error (notGradable) where this ticker was built without libclang.
[[nodiscard]] Candidates findCandidates(const build::Kit& kit, const sandbox::Sandbox& sandbox,
                                        const sandbox::Limits& limits, const std::string& file,
                                        std::string_view source, const Wanted& wanted);

/// The file with edits made in it; empty where two of them change the same text.
[[nodiscard]] std::optional<std::string> withEdits(std::string_view source,
                                                   std::vector<TextEdit> edits);

}  // namespace ticker::repair

#endif
