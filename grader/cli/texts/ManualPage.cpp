#include <grader/cli/CommandTree.h>

#include <fmt/core.h>

namespace ticker::cli {
namespace {

/// Escapes text for troff: backslashes and hyphens are printed unchanged, and a full stop or an
/// apostrophe at the beginning starts no control line.
std::string plain(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '\\')
            safe += "\\e";
        else if (c == '-')
            safe += "\\-";
        else
            safe += c;
    }
    const bool isControl = safe.starts_with('.') || safe.starts_with('\'');
    return isControl ? "\\&" + safe : safe;
}

std::string optionText(const OptionText& option) {
    std::string text = ".TP\n";
    for (std::size_t i = 0; i < option.names.size(); ++i)
        text += fmt::format("{}\\fB{}\\fR", i == 0 ? "" : ", ", plain(option.names[i]));
    if (!option.value.empty() && !option.isArgument())
        text += fmt::format(" \\fI{}\\fR", plain(option.value));
    text += "\n" + plain(option.description) + "\n";
    std::string choices;
    for (const std::string& choice : option.choices)
        choices += (choices.empty() ? "" : ", ") + choice;
    if (!choices.empty()) text += plain("One of: " + choices + ".") + "\n";
    return text;
}

std::string synopsis(const CommandTree& program, const CommandTree& verb) {
    std::string text = fmt::format(".B {} {}\n", plain(program.name), plain(verb.name));
    for (const OptionText& option : verb.options)
        if (option.isArgument()) text += fmt::format(".I {}\n", plain(option.names.front()));
    return text + "[options]\n";
}

}  // namespace

std::string manualPage(const CommandTree& program, const std::string& version) {
    std::string capitals;
    for (const char c : program.name)
        capitals += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    std::string text =
        fmt::format(".TH {} 1 \"\" \"{} {}\" \"User Commands\"\n", capitals, program.name, version);
    text += fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n.B {}\n.I verb\n[options]\n",
                        plain(program.name), plain(program.description), plain(program.name));
    text += ".SH OPTIONS\nThese go with every verb.\n";
    for (const OptionText& option : program.options)
        text += optionText(option);
    text += ".SH VERBS\n";
    for (const CommandTree& verb : program.verbs) {
        text += fmt::format(".SS {}\n{}.PP\n{}\n", plain(verb.name), synopsis(program, verb),
                            plain(verb.description));
        for (const OptionText& option : verb.options)
            text += optionText(option);
    }
    return text +
           ".SH EXIT STATUS\n0 done; 1 a check did not pass; 2 wrong usage or unreadable input; 3 "
           "something could not be graded, for reasons that are not the student's; 130 "
           "interrupted.\n";
}

}  // namespace ticker::cli
