#ifndef TICKER_TESTS_REPAIR_FOUNDEDITS_H
#define TICKER_TESTS_REPAIR_FOUNDEDITS_H

#include <grader/repair/Candidates.h>
#include <grader/repair/candidates/Tokens.h>
#include <grader/sandbox/SandboxPolicy.h>

#include <stdexcept>
#include <string>

namespace ticker::tests {

/// Without blanks and comments.
inline std::string tokens(const std::string& text) {
    std::string all;
    for (const candidates::Range& token : candidates::tokensOf(text))
        all += text.substr(token.begin, token.size()) + " ";
    return all;
}

/// Edits of a file of an exercise.
inline repair::Candidates found(const char* exercise, const std::string& file,
                                const std::string& text, repair::Reach reach,
                                const char* leftAlone) {
    const repair::Wanted wanted{reach, leftAlone,
                                exerciseNamed(exercise).formulasOf(file, leftAlone)};
    const auto candidates =
        findCandidates(build::Kit::besideProgram(exerciseNamed(exercise)), sandbox::Sandbox::best(),
                       sandbox::defaultPolicy().compile, file, text, wanted);
    if (candidates.program.empty()) throw std::runtime_error("cannot be parsed");
    return candidates;
}

}  // namespace ticker::tests

#endif
