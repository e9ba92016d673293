#ifndef TICKER_SIMILAR_MATCHER_H
#define TICKER_SIMILAR_MATCHER_H

#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/SandboxPolicy.h>
#include <grader/similar/Similar.h>

#include <cstddef>
#include <string>
#include <vector>

namespace ticker::similar {

/// A passage of file `left` that is in file `right` as well.
struct Match {
    std::size_t left = 0;
    std::size_t right = 0;
    Passage passage;
};

/// How much of one file is in another one.
struct Share {
    std::size_t file = 0;
    std::size_t other = 0;
    int percent = 0;
};

/// What is said of a matcher that did not finish: how it ended, and the beginning of what it wrote.
[[nodiscard]] std::string matcherFailure(std::size_t files, const sandbox::Outcome& outcome,
                                         const sandbox::Limits& limits);

/// Runs the matcher on texts, which are told apart by their index.
class Matcher {
public:
    /// @throws raytracer::InputError if it is not installed.
    explicit Matcher(const sandbox::Sandbox& sandbox,
                     const sandbox::Limits& limits = sandbox::defaultPolicy().match);

    /// Passages of each text that are in a known text. `right` counts the known ones.
    [[nodiscard]] std::vector<Match> against(const std::vector<std::string>& texts,
                                             const std::vector<std::string>& known) const;
    /// Passages that two texts share.
    [[nodiscard]] std::vector<Passage> between(const std::string& left,
                                               const std::string& right) const;
    /// All pairs of which a part is the same.
    [[nodiscard]] std::vector<Share> shares(const std::vector<std::string>& texts) const;

private:
    [[nodiscard]] std::string run(const std::vector<std::string>& options,
                                  const std::vector<std::string>& texts,
                                  const std::vector<std::string>& known = {}) const;

    const sandbox::Sandbox& sandbox_;
    sandbox::Limits limits_;
};

}  // namespace ticker::similar

#endif
