// A compiler in the jail: it works, and neither its output nor its messages contain anything of the
// host.
#include "JailFixture.h"

#include <grader/base/FileDescriptor.h>

#include <gtest/gtest.h>

#include <sys/mman.h>
#include <unistd.h>

#include <fstream>

namespace ticker::sandbox {
namespace {

namespace fs = std::filesystem;

class Compile : public AtLevel {
protected:
    void SetUp() override {
        AtLevel::SetUp();
        if (!fs::exists("/usr/bin/g++")) GTEST_SKIP() << "there is no /usr/bin/g++";
        source_ = {Sandbox::makeStagingFolder(), "/source"};
        fs::permissions(source_.host, fs::perms{0755});
    }
    void TearDown() override {
        fs::remove_all(source_.host);
        AtLevel::TearDown();
    }

    // Runs the compiler on one file; its output goes to product().
    Outcome compile(const std::string& text, const std::vector<std::string>& flags = {}) {
        std::ofstream{source_.host / "answer.cpp"} << text;
        Command command;
        command.readOnly = {{"/usr", "/usr"}, source_};
        // g++ may be a link through /etc, which does not exist in the jail.
        command.arguments = {fs::canonical("/usr/bin/g++").string(), "-O1", "-static", "-o",
                             "program"};
        command.arguments.insert(command.arguments.end(), flags.begin(), flags.end());
        const Sandbox sandbox = Sandbox::at(GetParam());
        command.arguments.push_back((sandbox.pathFor(source_) / "answer.cpp").string());
        command.folder = kScratchFolder;
        command.wantsScratch = true;
        command.policy = Policy::compile;
        command.limits.cpuSeconds = 20;
        command.limits.wallSeconds = 60;
        product_ = FileDescriptor{memfd_create("program", MFD_CLOEXEC)};
        command.products = {{"program", product_.get()}};
        return run(command);
    }

    [[nodiscard]] std::string product() const {
        std::string text(static_cast<std::size_t>(lseek(product_.get(), 0, SEEK_END)), '\0');
        EXPECT_EQ(pread(product_.get(), text.data(), text.size(), 0),
                  static_cast<ssize_t>(text.size()));
        return text;
    }

private:
    ReadOnlyPath source_;
    FileDescriptor product_;
};

INSTANTIATE_TEST_SUITE_P(Sandbox, Compile,
                         testing::Values(Level::namespaces, Level::ownUser, Level::sameUser),
                         levelName);

TEST_P(Compile, MakesAProgramThatRuns) {
    const Outcome outcome =
        compile("#include <iostream>\nint main() { std::cout << \"made\\n\"; }\n");
    ASSERT_EQ(describe(outcome), "exit 0") << outcome.output;
    EXPECT_FALSE(outcome.productsMissing);

    const fs::path program = Sandbox::makeStagingFolder() / "program";
    std::ofstream{program, std::ios::binary} << product();
    fs::permissions(program, fs::perms{0755});
    Command command = trick({});
    command.readOnly = {{program, "/program"}};
    command.arguments = {"/program"};
    const Outcome made = Sandbox::at(GetParam()).run(command);
    fs::remove_all(program.parent_path());
    EXPECT_EQ(describe(made), "exit 0");
    EXPECT_EQ(made.output, "made\n");
}

TEST_P(Compile, ShowsNoFileOfTheHostToTheCompiler) {
    const std::string secret = secretFile().string();
    for (const std::string& text :
         {"#include \"" + secret + "\"\nint main() {}\n",
          "asm(\".incbin \\\"" + secret + "\\\"\");\nint main() {}\n",
          std::string{"#include \"/etc/passwd\"\nint main() {}\n"},
          std::string{"asm(\".include \\\"/etc/passwd\\\"\");\nint main() {}\n"},
          std::string{"#include \"/proc/self/environ\"\nint main() {}\n"}}) {
        const Outcome outcome = compile(text);
        EXPECT_EQ(describe(outcome), "exit 1") << text;
        EXPECT_EQ(outcome.output.find("root:"), std::string::npos);
        EXPECT_EQ(product().find(kSecret), std::string::npos);
    }
}

TEST_P(Compile, ShowsNoEndlessDevice) {
    EXPECT_EQ(describe(compile("#include \"/dev/zero\"\nint main() {}\n")), "exit 1");
}

TEST_P(Compile, HandsOverNoProductThatIsALink) {
    // The compiler follows a link only if asked to; here the link is its product.
    Command command;
    command.readOnly = {{"/usr", "/usr"}};
    command.arguments = {fs::canonical("/usr/bin/ln").string(), "-s", secretFile().string(),
                         "program"};
    command.folder = kScratchFolder;
    command.wantsScratch = true;
    command.policy = Policy::compile;
    const FileDescriptor product{memfd_create("program", MFD_CLOEXEC)};
    command.products = {{"program", product.get()}};
    const Outcome outcome = run(command);
    EXPECT_EQ(describe(outcome), "exit 0") << outcome.output;
    EXPECT_TRUE(outcome.productsMissing);
    EXPECT_EQ(lseek(product.get(), 0, SEEK_END), 0);
}

// A checkout may lie in /tmp, where jobs have their own files.
TEST_P(Compile, ShowsWhatLiesBelowTheScratchFolder) {
    const fs::path host = "/usr/include";
    const fs::path inside = fs::path{kScratchFolder} / "checkout" / "include";
    Command command;
    command.readOnly = {{"/usr", "/usr"}, {host, inside}};
    command.arguments = {fs::canonical("/usr/bin/ls").string(),
                         (GetParam() == Level::namespaces ? inside : host) / "stdio.h"};
    command.folder = kScratchFolder;
    command.wantsScratch = true;
    command.policy = Policy::compile;
    const Outcome outcome = run(command);
    EXPECT_EQ(describe(outcome), "exit 0") << outcome.output;
}

TEST_P(Compile, LetsTheCompilerWriteNowhereElse) {
    const fs::path elsewhere = fs::path{"/var/tmp"} / marker();
    const Outcome outcome = compile("int main() {}\n", {"-o", elsewhere.string()});
    EXPECT_EQ(describe(outcome), "exit 1") << outcome.output;
    EXPECT_FALSE(fs::exists(elsewhere));
}

}  // namespace
}  // namespace ticker::sandbox
