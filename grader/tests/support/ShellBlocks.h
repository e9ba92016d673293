#ifndef TICKER_TESTS_SUPPORT_SHELLBLOCKS_H
#define TICKER_TESTS_SUPPORT_SHELLBLOCKS_H

#include <string>
#include <vector>

namespace ticker::tests {

/// The text between ```sh and ``` in a Markdown file.
struct ShellBlock {
    std::string where;     ///< "docs/for-tickers.md:7"
    std::string commands;  ///< as written, with line ends
    std::string skip;      ///< why no test can run it, from ```sh skip="..."; empty: tests run it

    /// Number of commands: lines without comments and continuations.
    [[nodiscard]] int count() const;
};

/// The shell blocks of a file of the project, from top to bottom.
/// @param name  Path from the project's root.
/// @throws std::runtime_error if a fence is not closed, or has an unknown option.
[[nodiscard]] std::vector<ShellBlock> shellBlocks(const std::string& name);

/// A bash script that runs the commands of the blocks that tests can run. It ends with the first
/// failure and prints its place.
[[nodiscard]] std::string scriptOf(const std::vector<ShellBlock>& blocks);

/// One line for each block that no test runs: where, how many commands, why.
[[nodiscard]] std::string skippedIn(const std::vector<ShellBlock>& blocks);

}  // namespace ticker::tests

#endif
