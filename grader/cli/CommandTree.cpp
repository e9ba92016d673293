#include <grader/cli/CommandTree.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace ticker::cli {
namespace {

/// The names in "TEXT:{html,json}".
std::vector<std::string> choicesIn(std::string_view type) {
    const std::size_t open = type.find('{');
    const std::size_t close = type.find('}');
    std::vector<std::string> choices;
    if (open == std::string_view::npos || close == std::string_view::npos) return choices;
    std::string_view rest = type.substr(open + 1, close - open - 1);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(','), rest.size());
        choices.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return choices;
}

OptionText describeOption(const CLI::Option& option) {
    OptionText text;
    for (const std::string& name : option.get_snames())
        text.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames())
        text.names.push_back("--" + name);
    if (text.names.empty()) text.names.push_back(option.get_name());
    const std::string type = option.get_type_name();
    const bool isFlag = option.get_items_expected_max() == 0;
    if (!isFlag) text.value = type.substr(0, type.find_first_of(":{["));
    text.choices = choicesIn(type);
    text.description = option.get_description();
    return text;
}

}  // namespace

CommandTree describe(const CLI::App& app) {
    CommandTree tree{app.get_name(), app.get_description(), {}, {}};
    for (const CLI::Option* option : app.get_options())
        if (!option->get_group().empty()) tree.options.push_back(describeOption(*option));
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
        if (!verb->get_group().empty()) tree.verbs.push_back(describe(*verb));
    return tree;
}

}  // namespace ticker::cli
