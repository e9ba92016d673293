#include <grader/base/ShellQuoted.h>
#include <grader/cli/CommandTree.h>

#include <fmt/core.h>

namespace ticker::cli {
namespace {

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

/// Text inside single quotes; `also` are further characters that get a backslash.
std::string inSingleQuotes(const std::string& text, std::string_view also = {}) {
    std::string safe;
    for (const char c : text)
        safe += also.find(c) == std::string_view::npos ? std::string{c} : std::string{"\\"} + c;
    return insideSingleQuotes(safe);
}

std::vector<std::string> namesOf(const std::vector<CommandTree>& verbs) {
    std::vector<std::string> names;
    for (const CommandTree& verb : verbs)
        names.push_back(verb.name);
    return names;
}

std::string optionNames(const CommandTree& program, const CommandTree& verb) {
    std::vector<std::string> names;
    for (const std::vector<OptionText>* options : {&verb.options, &program.options})
        for (const OptionText& option : *options)
            if (!option.isArgument())
                names.insert(names.end(), option.names.begin(), option.names.end());
    return joined(names);
}

/// Lines of a `case`: what follows an option of a verb.
std::string bashChoices(const CommandTree& verb) {
    std::string text;
    for (const OptionText& option : verb.options) {
        if (option.choices.empty() || option.isArgument()) continue;
        for (const std::string& name : option.names)
            text += fmt::format("    {}:{}) choices='{}' ;;\n", verb.name, name,
                                joined(option.choices));
    }
    return text;
}

std::string bash(const CommandTree& program) {
    std::string choices;
    std::string options;
    for (const CommandTree& verb : program.verbs) {
        choices += bashChoices(verb);
        std::string arguments;
        for (const OptionText& option : verb.options)
            if (option.isArgument()) arguments += joined(option.choices);
        options += fmt::format("    {}) words='{}' arguments='{}' ;;\n", verb.name,
                               optionNames(program, verb), arguments);
    }
    return fmt::format(R"(# bash completion for {0}; {0} --completion bash prints it.
_{0}() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD-1]}}"
  local verb="${{COMP_WORDS[1]}}" words='' choices='' arguments=''
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W '{1} {2}' -- "$word")
    return
  fi
  case "$verb:$before" in
{3}    *) ;;
  esac
  case "$verb" in
{4}    *) ;;
  esac
  if [[ -n "$choices" ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$word")
  elif [[ "$word" == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  elif [[ -n "$arguments" ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$arguments" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}}
complete -o filenames -F _{0} {0}
)",
                       program.name, joined(namesOf(program.verbs)),
                       optionNames({}, {{}, {}, program.options, {}}), choices, options);
}

std::string zshOption(const OptionText& option) {
    const std::string description = inSingleQuotes(option.description, "[]:\\");
    const std::string values =
        option.choices.empty() ? "_files" : "(" + joined(option.choices) + ")";
    if (option.isArgument())
        return fmt::format(" \\\n        '*:{}:{}'", inSingleQuotes(option.names.front(), ":"),
                           values);
    std::string text;
    for (const std::string& name : option.names)
        text += fmt::format(" \\\n        '{}[{}]{}'", name, description,
                            option.value.empty() ? "" : ":" + option.value + ":" + values);
    return text;
}

std::string zsh(const CommandTree& program) {
    std::string verbs;
    std::string cases;
    for (const CommandTree& verb : program.verbs) {
        verbs += fmt::format("      '{}:{}'\n", verb.name, inSingleQuotes(verb.description, ":\\"));
        cases += fmt::format("    {})\n      _arguments", verb.name);
        for (const OptionText& option : verb.options)
            cases += zshOption(option);
        cases += " ;;\n";
    }
    return fmt::format(R"(#compdef {0}
# {0} --completion zsh prints this.
_{0}() {{
  local -a verbs
  if ((CURRENT == 2)); then
    verbs=(
{1}    )
    _describe verb verbs
    return
  fi
  local verb="$words[2]"
  shift words
  ((CURRENT--))
  case "$verb" in
{2}  esac
}}
_{0} "$@"
)",
                       program.name, verbs, cases);
}

std::string fishOption(const std::string& program, const std::string& condition,
                       const OptionText& option) {
    std::string text = fmt::format("complete -c {} -n '{}'", program, condition);
    for (const std::string& name : option.names) {
        if (name.starts_with("--"))
            text += " -l " + name.substr(2);
        else if (name.starts_with('-'))
            text += " -s " + name.substr(1);
    }
    if (!option.choices.empty()) text += fmt::format(" -a '{}'", joined(option.choices));
    if (!option.value.empty() && !option.isArgument()) text += " -r";
    return text + fmt::format(" -d '{}'\n", inSingleQuotes(option.description));
}

std::string fish(const CommandTree& program) {
    std::string text = fmt::format("# {0} --completion fish prints this.\n", program.name);
    for (const OptionText& option : program.options)
        text += fishOption(program.name, "true", option);
    for (const CommandTree& verb : program.verbs) {
        text += fmt::format("complete -c {} -f -n __fish_use_subcommand -a {} -d '{}'\n",
                            program.name, verb.name, inSingleQuotes(verb.description));
        for (const OptionText& option : verb.options)
            if (!option.isArgument() || !option.choices.empty())
                text +=
                    fishOption(program.name, "__fish_seen_subcommand_from " + verb.name, option);
    }
    return text;
}

}  // namespace

std::string completionScript(const CommandTree& program, const std::string& shell) {
    if (shell == "zsh") return zsh(program);
    return shell == "fish" ? fish(program) : bash(program);
}

}  // namespace ticker::cli
