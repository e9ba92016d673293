#include <grader/tests/support/Files.h>
#include <grader/tests/support/ShellBlocks.h>

#include <regex>
#include <sstream>
#include <stdexcept>

namespace ticker::tests {
namespace {

/// The reason why a fence's block is not run; empty without a reason.
std::string skipOf(const std::string& fence, const std::string& where) {
    static const std::regex kFence{R"re(```sh( skip="([^"]+)")?)re"};
    std::smatch match;
    if (!std::regex_match(fence, match, kFence))
        throw std::runtime_error(where + ": expected ```sh or ```sh skip=\"why\", got " + fence);
    return match[2];
}

}  // namespace

int ShellBlock::count() const {
    int found = 0;
    bool goesOn = false;
    std::istringstream lines{commands};
    for (std::string line; std::getline(lines, line);) {
        const bool isCommand = !line.empty() && line.front() != '#' && !goesOn;
        if (isCommand) ++found;
        goesOn = line.ends_with('\\');
    }
    return found;
}

std::vector<ShellBlock> shellBlocks(const std::string& name) {
    std::istringstream lines{readFile(name)};
    std::vector<ShellBlock> blocks;
    bool inside = false;
    bool isShell = false;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.starts_with("```") && !inside) {
            inside = true;
            isShell = line.starts_with("```sh");
            const std::string where = name + ":" + std::to_string(number);
            if (isShell) blocks.push_back({where, "", skipOf(line, where)});
        } else if (line.starts_with("```")) {
            inside = false;
        } else if (inside && isShell) {
            blocks.back().commands += line + "\n";
        }
    }
    if (inside) throw std::runtime_error(name + ": a fence is not closed");
    return blocks;
}

std::string scriptOf(const std::vector<ShellBlock>& blocks) {
    std::string script =
        "set -euo pipefail\n"
        "trap 'echo \"$where: exit status $? of: $BASH_COMMAND\"' ERR\n";
    for (const ShellBlock& block : blocks)
        if (block.skip.empty()) script += "where=" + block.where + "\n" + block.commands;
    return script;
}

std::string skippedIn(const std::vector<ShellBlock>& blocks) {
    std::string text;
    for (const ShellBlock& block : blocks)
        if (!block.skip.empty())
            text += block.where + ": " + std::to_string(block.count()) + " not run, " + block.skip +
                    "\n";
    return text;
}

}  // namespace ticker::tests
