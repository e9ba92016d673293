#include <grader/build/Kit.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace ticker::build {
namespace {

namespace fs = std::filesystem;

std::string outputOf(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe{popen(command.c_str(), "r"), pclose};
    std::string output;
    std::array<char, 4096> buffer{};
    while (const std::size_t size = fread(buffer.data(), 1, buffer.size(), pipe.get()))
        output.append(buffer.data(), size);
    return output;
}

TEST(Kit, LiesBesideTheProgramsOfItsBuildTree) {
    const Kit kit = Kit::besideProgram();
    EXPECT_TRUE(std::filesystem::exists(kit.folder() / "include/raytracer/render/Renderer.h"));
    EXPECT_EQ(kit.templateSource("Renderer.cpp"),
              tests::readFile("student_template/exercise/Renderer.cpp"));
}

const std::vector<std::string> kParts{"kit.json", "lib/libkit.a", "lib/probe.o",
                                      "pch/Framework.h.gch", "template/Renderer.o"};

/// A kit without contents, of private files.
void writePrivateKit(const fs::path& folder) {
    std::vector<std::string> names = kParts;
    names.emplace_back("include/raytracer/base/Error.h");
    for (const std::string& name : names) {
        fs::create_directories((folder / name).parent_path());
        std::ofstream{folder / name}
            << R"({"version": 1, "madeAt": "", "compiler": "", "compile": [], "quick": [],)"
            << R"( "link": [], "files": ["Renderer.cpp"]})";
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder})
        fs::permissions(entry, fs::perms{entry.is_directory() ? 0700U : 0600U});
}

/// Why a folder is no kit; empty if it is one.
std::string complaintAbout(const fs::path& folder) {
    try {
        static_cast<void>(Kit::at(folder));
    } catch (const raytracer::Error& error) {
        return error.what();
    }
    return "";
}

TEST(Kit, IsRefusedWhereItIsNotWholeNamingWhatItLacks) {
    const tests::TemporaryFolder folder;
    EXPECT_NE(complaintAbout(folder.path() / "nowhere").find("nowhere/kit.json"),
              std::string::npos);
    for (const std::string& part : kParts) {
        const fs::path kit = folder.path() / "kit";
        writePrivateKit(kit);
        EXPECT_EQ(complaintAbout(kit), "") << "it is whole";
        fs::remove(kit / part);
        EXPECT_NE(complaintAbout(kit).find("the kit lacks " + (kit / part).string()),
                  std::string::npos)
            << part;
    }
}

/// The files and folders that users other than the owner cannot read.
std::vector<std::string> closedToOthers(const fs::path& folder) {
    std::vector<std::string> closed;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder}) {
        const fs::perms needed{entry.is_directory() ? 0005U : 0004U};
        if ((entry.status().permissions() & needed) != needed) closed.push_back(entry.path());
    }
    return closed;
}

// Jobs of root run as another user. If he could not read the headers, no student's file would
// compile.
TEST(Kit, CanBeReadByEveryJobWhateverTheUmaskOfRootIs) {
    if (geteuid() != 0) GTEST_SKIP() << "only the jobs of root have another uid";
    const tests::TemporaryFolder folder;
    const mode_t before = umask(0077);
    writePrivateKit(folder.path() / "kit");
    for (const unsigned mode : {0755U, 0700U}) {
        fs::permissions(folder.path(), fs::perms{mode});
        const Kit kit = Kit::at(folder.path() / "kit");
        EXPECT_EQ(closedToOthers(kit.folder()), std::vector<std::string>{}) << mode;
        EXPECT_EQ(closedToOthers(kit.folder().parent_path()), std::vector<std::string>{}) << mode;
    }
    umask(before);
}

// The compiler prints "!" before a precompiled header that it uses, "x" before one that it rejects.
TEST(Kit, PrecompiledHeaderFitsTheFlags) {
    const Kit kit = Kit::besideProgram();
    std::string command = kit.compiler();
    for (const std::string& flag : kit.compileFlags())
        command += " " + flag;
    command += " -I" + (kit.folder() / "include").string() + " -include " +
               (kit.folder() / "pch/Framework.h").string() +
               " -Winvalid-pch -H -fsyntax-only -x c++ /dev/null 2>&1";

    const std::string output = outputOf(command);

    EXPECT_TRUE(output.starts_with("! ")) << output;
    EXPECT_NE(output.find("Framework.h.gch"), std::string::npos) << output;
}

// Clang's precompiled headers contain the path where they were made. "madeAt" shows that a kit was
// moved: its headers are then precompiled again.
TEST(Kit, HoldsNoPathOfTheProjectButThatWhereItWasMade) {
    const Kit kit = Kit::besideProgram();
    std::string json =
        tests::readFile(std::filesystem::relative(kit.folder() / "kit.json", TICKER_SOURCE_DIR));
    const std::size_t made = json.find("\"madeAt\"");
    ASSERT_NE(made, std::string::npos);
    json.erase(made, json.find('\n', made) - made);
    EXPECT_EQ(json.find(TICKER_SOURCE_DIR), std::string::npos);
}

}  // namespace
}  // namespace ticker::build
