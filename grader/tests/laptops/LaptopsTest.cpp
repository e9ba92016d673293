// From the package's zip to pictures and public tests, for each kind of laptop that can be had
// here. The libraries are downloaded as on a machine that has none of them.
#include <grader/tests/student/UnpackedPackage.h>
#include <grader/tests/support/CompilerCache.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace ticker {
namespace {

namespace fs = std::filesystem;
using tests::CommandResult;

// In a folder that is usually empty: the jail hides what else is in it.
constexpr const char* kOddPath = "/var/opt/Tick für Zoë (2)";
const std::string kWine{TICKER_BINARY_DIR "/wine"};

bool isInstalled(const std::string& program) {
    return tests::runCommand("command -v " + program).status == 0;
}

/// Whether the package's libraries can be had: asks for a small file of the same archive.
bool hasNetwork() {
    const tests::TemporaryFolder folder;
    folder.write("ask.cmake",
                 "file(DOWNLOAD https://deb.debian.org/debian/dists/bookworm/Release.gpg release "
                 "STATUS status)\nlist(GET status 0 status)\nif(status)\n"
                 "message(FATAL_ERROR offline)\nendif()\n");
    return tests::runCommand("cd '" + folder.path().string() + "' && cmake -P ask.cmake").status ==
           0;
}

std::string withWindowsLineEnds(std::string text) {
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 2))
        text.insert(at, "\r");
    return text;
}

/// A package with every task solved, below a name that scripts stumble over, on another system.
class Laptop {
public:
    explicit Laptop(const std::string& toolchain, const Exercise& exercise = defaultExercise())
        : toolchain_(toolchain), package_(exercise) {
        // With line ends as an editor on Windows writes them.
        for (const std::string& name : exercise.files())
            std::ofstream{folder() / "exercise" / name}
                << withWindowsLineEnds(tests::readFile(exercise.reference + "/" + name));
        for (const SceneEntry& scene : exercise.scenes)
            std::ofstream{folder() / "scenes" / (scene.name + ".xml")}
                << withWindowsLineEnds(tests::readFile("scenes/" + scene.name + ".xml"));
    }

    [[nodiscard]] fs::path folder() const { return package_.folder(); }

    /// Runs a command in the folder, which has the same odd path each time. Wine sets up its own
    /// folder the first time, which takes longer than all else, and keeps it in the build folder.
    [[nodiscard]] CommandResult run(const std::string& command) const {
        work_.write("command", command);
        const std::map<std::string, std::string> environment{
            {"LC_ALL", "C.UTF-8"},
            {"WINEDEBUG", "-all"},
            {"WINEPREFIX", kWine},
            {"CMAKE_TOOLCHAIN_FILE", TICKER_SOURCE_DIR "/grader/tests/laptops/" + toolchain_}};
        std::string jail = "bwrap --dev-bind / / --tmpfs /var/opt " +
                           tests::compilerCacheFor("/var/opt/ccache") + "--bind '" +
                           folder().string() + "' '" + kOddPath + "' --chdir '" + kOddPath + "'";
        for (const auto& [name, value] : environment)
            jail += " --setenv " + name + " '" + value + "'";
        return tests::runCommand(jail + " bash '" + (work_.path() / "command").string() + "'");
    }

private:
    std::string toolchain_;
    tests::UnpackedPackage package_;
    tests::TemporaryFolder work_;
};

/// Wine's server sees the files of the laptop that started it, and outlives it. Only the tests of
/// Windows may end it: others run beside them.
class WindowsLaptop : public Laptop {
public:
    explicit WindowsLaptop(const Exercise& exercise = defaultExercise())
        : Laptop{"windows.cmake", exercise} {
        static_cast<void>(tests::runCommand("WINEPREFIX='" + kWine + "' wineserver -k"));
    }
};

void expectThatAllPublicTestsPass(const CommandResult& checked) {
    EXPECT_EQ(checked.status, 0) << checked.output;
    for (const char* line :
         {"The first time, everything is built", "Building: 50 %", "T1   bump mapping:   11 of 11",
          "T2.1 soft shadows:   11 of 11", "T2.2 depth of field: 11 of 11",
          "Hand in exercise/BumpySphere.cpp and exercise/Renderer.cpp"})
        EXPECT_NE(checked.output.find(line), std::string::npos) << line << "\n" << checked.output;
}

/// Renders the handout's scenes here and there: pictures, and colours before they become bytes.
void expectEqualPictures(const Laptop& laptop, const std::string& program) {
    for (const std::string scene : {"bump-mapping", "distributed"}) {
        const std::string options = " -r 96x72 --seed 5 --quiet -i scenes/" + scene + ".xml";
        const CommandResult there =
            laptop.run(program + options + " -o 'pictures/ö " + scene + ".png' --linear there.pfm");
        EXPECT_EQ(there.status, 0) << there.output;
        const CommandResult here =
            laptop.run(TICKER_BINARY_DIR "/bin/tick1star-reference --assets assets" + options +
                       " -o here.png --linear here.pfm");
        EXPECT_EQ(here.status, 0) << here.output;
        const CommandResult compared =
            laptop.run("cmp here.png 'pictures/ö " + scene + ".png' && cmp here.pfm there.pfm");
        EXPECT_EQ(compared.status, 0) << scene << ": " << compared.output;
    }
}

TEST(Laptops, AWindowsPackageBuildsPassesAndRendersTheSamePictures) {
    if (!isInstalled("x86_64-w64-mingw32-g++-posix") || !isInstalled("wine"))
        GTEST_SKIP() << "needs g++-mingw-w64-x86-64 and wine";
    if (!hasNetwork()) GTEST_SKIP() << "needs the network";
    const WindowsLaptop laptop;
    expectThatAllPublicTestsPass(laptop.run("./check"));
    for (const char* picture : {"bump-mapping", "bumpmap-test", "distributed"})
        EXPECT_TRUE(fs::exists(laptop.folder() / "pictures" / (std::string{picture} + ".png")));
    expectEqualPictures(laptop, "wine build/tick1star.exe");
}

TEST(Laptops, TheMainTicksWindowsPackageBuildsAndPasses) {
    if (!isInstalled("x86_64-w64-mingw32-g++-posix") || !isInstalled("wine"))
        GTEST_SKIP() << "needs g++-mingw-w64-x86-64 and wine";
    if (!hasNetwork()) GTEST_SKIP() << "needs the network";
    const Exercise& exercise = exerciseNamed("tick1");
    const WindowsLaptop laptop{exercise};
    const CommandResult checked = laptop.run("./check");
    EXPECT_EQ(checked.status, 0) << checked.output;
    for (const char* line :
         {"spheres:            4 of 4", "Phong illumination: 4 of 4", "planes:             3 of 3",
          "shadows:            3 of 3", "reflections:        4 of 4"})
        EXPECT_NE(checked.output.find(line), std::string::npos) << line << "\n" << checked.output;
    for (const SceneEntry& scene : exercise.scenes)
        EXPECT_TRUE(fs::exists(laptop.folder() / "pictures" / (scene.name + ".png"))) << scene.name;
}

TEST(Laptops, WindowsHandsItsCheckTheArgumentsAndTheStatusOfTheOneScript) {
    if (!isInstalled("x86_64-w64-mingw32-g++-posix") || !isInstalled("wine"))
        GTEST_SKIP() << "needs g++-mingw-w64-x86-64 and wine";
    const WindowsLaptop laptop;
    const CommandResult missing = laptop.run("wine cmd /c check.cmd --quick");
    EXPECT_EQ(missing.status, 2) << missing.output;
    EXPECT_NE(missing.output.find("cmake is missing; README.md says"), std::string::npos)
        << missing.output;

    std::ofstream{laptop.folder() / "stand-in.cpp"} << R"(#include <cstdio>
        int main(int count, char** words) {
            if (count == 2) return 0;
            for (int i = 1; i < count; ++i) std::printf("<%s>", words[i]);
            std::FILE* status = std::fopen("build/check-status", "w");
            std::fputs("1\n", status);
            return std::fclose(status);
        })";
    const CommandResult ran = laptop.run(
        "x86_64-w64-mingw32-g++-posix -static stand-in.cpp -o cmake.exe && "
        "wine cmd /c check.cmd --quick");
    EXPECT_EQ(ran.status, 1) << ran.output;
    EXPECT_NE(ran.output.find("<-P><cmake/check.cmake><--><--quick>"), std::string::npos)
        << ran.output;
    // The program that is built has the exercise's name, which the build leaves in a file.
    fs::create_directories(laptop.folder() / "build/release");
    std::ofstream{laptop.folder() / "build/release/program"} << "stand-in\n";
    const CommandResult broken = laptop.run("wine cmd /c check.cmd --view");
    EXPECT_EQ(broken.status, 1) << broken.output;
    EXPECT_NE(broken.output.find("<--><--build>"), std::string::npos) << broken.output;
    fs::copy_file(laptop.folder() / "cmake.exe", laptop.folder() / "build/stand-in.exe");
    const CommandResult shown =
        laptop.run("wine cmd /c check.cmd --view 'my scenes/a (2).xml' --trace 3,4");
    EXPECT_NE(shown.output.find("<--view><my scenes/a (2).xml><--trace><3,4>"), std::string::npos)
        << shown.output;
}

TEST(Laptops, AMacsLibraryBuildsPassesAndRendersTheSamePictures) {
    if (!isInstalled("clang++-14") || !fs::exists("/usr/lib/llvm-14/include/c++/v1/vector"))
        GTEST_SKIP() << "needs clang-14 and libc++-14-dev";
    if (!hasNetwork()) GTEST_SKIP() << "needs the network";
    const Laptop laptop{"libcxx.cmake"};
    expectThatAllPublicTestsPass(laptop.run("./check"));
    expectEqualPictures(laptop, "build/tick1star");
    const CommandResult linked = laptop.run("ldd build/tick1star");
    EXPECT_NE(linked.output.find("libc++.so.1"), std::string::npos) << linked.output;
}

}  // namespace
}  // namespace ticker
