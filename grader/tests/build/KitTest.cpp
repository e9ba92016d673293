#include <grader/build/Kit.h>
#include <grader/tests/support/Files.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>

namespace ticker::build {
namespace {

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

TEST(Kit, IsRefusedWhereItIsNotWhole) {
    EXPECT_THROW(static_cast<void>(Kit::at("/nowhere")), raytracer::Error);
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

// Clang's precompiled headers name the place where they were made; a kit that was moved sees it by
// this member and makes them anew.
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
