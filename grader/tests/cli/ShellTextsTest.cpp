// What is made from the command line's own description: the manual page and the completions.
#include <grader/tests/support/RunCommand.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace ticker::cli {
namespace {

using tests::CommandResult;
using tests::runCommand;

const std::string kTicker = TICKER_BINARY_DIR "/bin/ticker";

/// The completions that bash offers for the word at `position`, with these words typed.
std::string bashOffers(const std::string& words, int position) {
    return runCommand("bash -c 'source <(" + kTicker + " --completion bash); COMP_WORDS=(" + words +
                      "); COMP_CWORD=" + std::to_string(position) +
                      "; _ticker; echo ${COMPREPLY[@]}'")
        .output;
}

TEST(Completion, OfBashKnowsVerbsOptionsAndChoices) {
    EXPECT_EQ(bashOffers("ticker rep", 1), "report\n");
    EXPECT_EQ(bashOffers("ticker report --worksh", 2), "--worksheet\n");
    EXPECT_EQ(bashOffers("ticker report --format pra", 3), "prairielearn\n");
    EXPECT_EQ(bashOffers("ticker package stu", 2), "student\n");
    EXPECT_EQ(bashOffers("ticker selfte", 1), "\n") << "hidden verbs stay hidden";
}

TEST(Completion, IsUnderstoodByItsShell) {
    for (const std::string shell : {"bash", "zsh", "fish"}) {
        if (runCommand("command -v " + shell).status != 0) continue;
        const CommandResult read =
            runCommand("t=$(mktemp) && " + kTicker + " --completion " + shell + " >$t && " + shell +
                       " -n $t; s=$?; rm -f $t; exit $s");
        EXPECT_EQ(read.status, 0) << shell << ": " << read.output;
        EXPECT_EQ(read.output, "") << shell;
    }
    EXPECT_EQ(runCommand(kTicker + " --completion csh").status, 2);
}

TEST(Completion, OfFishOffersChoices) {
    if (runCommand("command -v fish").status != 0) GTEST_SKIP() << "needs fish";
    const CommandResult offers =
        runCommand("fish -c '" + kTicker + " --completion fish | source; " +
                   "complete -C\"ticker report --format pra\"'");
    EXPECT_NE(offers.output.find("prairielearn"), std::string::npos) << offers.output;
}

TEST(ManualPage, NamesEveryVerbAndIsCleanTroff) {
    const CommandResult page = runCommand(kTicker + " --manual");
    EXPECT_EQ(page.status, 0) << page.output;
    for (const char* part :
         {".TH TICKER 1", ".SS grade", ".SS session", "\\fB\\-\\-worksheet\\fR", ".SH EXIT STATUS"})
        EXPECT_NE(page.output.find(part), std::string::npos) << part;
    EXPECT_EQ(page.output.find("selftest"), std::string::npos);
    if (runCommand("command -v man && command -v groff").status != 0) return;
    const CommandResult formatted = runCommand(kTicker + " --manual | groff -man -Tutf8 -ww -z");
    EXPECT_EQ(formatted.output, "");
}

/// The answer of git about this folder; empty outside of a checkout.
std::string gitSays(const std::string& question) {
    const CommandResult answer =
        runCommand("cd " TICKER_SOURCE_DIR " && git rev-parse " + question + " 2>/dev/null");
    return answer.status == 0 ? answer.output.substr(0, answer.output.find('\n')) : "";
}

TEST(Version, NamesTheCommitWhereThereIsOne) {
    namespace fs = std::filesystem;
    const std::string head = gitSays("--short=10 HEAD");
    if (head.empty()) GTEST_SKIP() << "no checkout";
    const std::string version = runCommand(kTicker + " --version").output;
    const bool isNamed = version.find(" (" + head + ")") != std::string::npos;
    const fs::path log = fs::path{TICKER_SOURCE_DIR} / gitSays("--git-path logs/HEAD");
    std::error_code error;
    if (!isNamed && fs::last_write_time(log, error) > fs::last_write_time(kTicker))
        GTEST_SKIP() << "a commit came after this build";
    EXPECT_TRUE(isNamed) << version << "of " << head;
}

}  // namespace
}  // namespace ticker::cli
