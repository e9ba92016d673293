#ifndef TICKER_CLI_COMMANDTREE_H
#define TICKER_CLI_COMMANDTREE_H

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ticker::cli {

/// An option, a flag or an argument of a verb.
struct OptionText {
    std::vector<std::string> names;  ///< "-o", "--output"; an argument's name without dashes
    std::string value;               ///< what follows: "TEXT"; empty for flags
    std::vector<std::string> choices;
    std::string description;

    [[nodiscard]] bool isArgument() const { return !names.front().starts_with('-'); }
};

/// A program or one of its verbs, for texts that are made from it.
struct CommandTree {
    std::string name;
    std::string description;
    std::vector<OptionText> options;
    std::vector<CommandTree> verbs;
};

/// What the command line's own description says; hidden verbs and options are left out.
[[nodiscard]] CommandTree describe(const CLI::App& app);

/// A page for man(1), in troff.
[[nodiscard]] std::string manualPage(const CommandTree& program, const std::string& version);

/// A script for `bash`, `zsh` or `fish`.
[[nodiscard]] std::string completionScript(const CommandTree& program, const std::string& shell);

}  // namespace ticker::cli

#endif
