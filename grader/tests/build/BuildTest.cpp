#include <grader/build/Build.h>
#include <grader/sandbox/SandboxPolicy.h>
#include <grader/tests/support/Files.h>

#include <gtest/gtest.h>

namespace ticker::build {
namespace {

using Kind = BuildResult::Kind;

const sandbox::Sandbox& theSandbox() {
    static const sandbox::Sandbox instance = sandbox::Sandbox::best();
    return instance;
}

BuildResult build(const std::string& file, const std::string& source) {
    static const Kit kit = Kit::besideProgram();
    sandbox::Limits limits = sandbox::defaultPolicy().compile;
    limits.cpuSeconds = 10.0;
    return buildProgram(kit, theSandbox(), limits, file, source);
}

std::string reference(const char* name) {
    return tests::readFile("reference_solution/exercise/" + std::string{name});
}

TEST(Build, MakesAProgramOfEachReferenceFile) {
    for (const std::string file : {"BumpySphere.cpp", "Renderer.cpp"}) {
        const BuildResult result = build(file, reference(file.c_str()));
        EXPECT_EQ(result.kind, Kind::built) << result.diagnostics;
        ASSERT_TRUE(result.program);
        EXPECT_GT(std::filesystem::file_size(result.program->file()), 100'000U);
        EXPECT_EQ(result.diagnostics, "");
    }
}

TEST(Build, RemovesTheProgramWithItsOwner) {
    std::filesystem::path file;
    {
        const BuildResult result = build("BumpySphere.cpp", reference("BumpySphere.cpp"));
        ASSERT_TRUE(result.program);
        file = result.program->file();
    }
    EXPECT_FALSE(std::filesystem::exists(file.parent_path()));
}

TEST(Build, ShowsErrorsWithTheStudentsFileAndLineAndNoPathOfThisMachine) {
    const BuildResult result = build("BumpySphere.cpp", "int x = 1;\nint y = nonsense;\n");

    EXPECT_EQ(result.kind, Kind::failed);
    EXPECT_FALSE(result.program);
    EXPECT_TRUE(result.diagnostics.starts_with("BumpySphere.cpp:2:9: error: 'nonsense'"))
        << result.diagnostics;
    EXPECT_EQ(result.diagnostics.find("/source"), std::string::npos);
    EXPECT_EQ(result.diagnostics.find(TICKER_SOURCE_DIR), std::string::npos);
}

// With `using namespace std`, names of headers that the file does not include must not break it.
TEST(Build, DoesNotBlameAFileForThePrecompiledHeader) {
    const std::string source =
        "#include <raytracer/geometry/BumpySphere.h>\n"
        "using namespace std;\n"
        "static double normal_distribution = 1.0;\n"
        "raytracer::Vector3 raytracer::BumpySphere::getNormalAt(\n"
        "    const Vector3& p) const {\n"
        "    return Sphere::getNormalAt(p) * normal_distribution;\n"
        "}\n";
    EXPECT_EQ(build("BumpySphere.cpp", source).kind, Kind::built);
}

// The precompiled header may cause a compile error, but not a link error.
TEST(Build, CompilesASecondTimeOnlyWhereTheFirstDidNotCompile) {
    EXPECT_EQ(build("BumpySphere.cpp", reference("BumpySphere.cpp")).compilations, 1);
    EXPECT_EQ(build("BumpySphere.cpp", "int x = nonsense;\n").compilations, 2);
    const BuildResult unlinked = build("BumpySphere.cpp", "int x = 1;\n");
    EXPECT_EQ(unlinked.kind, Kind::failed);
    EXPECT_EQ(unlinked.compilations, 1);
    EXPECT_NE(unlinked.diagnostics.find("undefined symbol: vtable for raytracer::BumpySphere"),
              std::string::npos)
        << unlinked.diagnostics;
}

TEST(Build, RefusesAnOwnMain) {
    const BuildResult result =
        build("BumpySphere.cpp", reference("BumpySphere.cpp") + "int main() { return 0; }\n");
    EXPECT_EQ(result.kind, Kind::forbidden);
    EXPECT_NE(result.diagnostics.find("main"), std::string::npos) << result.diagnostics;
    EXPECT_NE(result.diagnostics.find("BumpySphere.cpp"), std::string::npos) << result.diagnostics;
    EXPECT_EQ(result.diagnostics.find("/tmp"), std::string::npos) << result.diagnostics;
}

// The probe ends by _Exit: a submission's own version would run after the last answer.
TEST(Build, RefusesAnOwnExit) {
    const BuildResult result =
        build("BumpySphere.cpp",
              reference("BumpySphere.cpp") +
                  "extern \"C\" [[noreturn]] void _Exit(int) noexcept { while (true) {} }\n");
    EXPECT_EQ(result.kind, Kind::forbidden) << result.diagnostics;
}

TEST(Build, RefusesAnOwnVersionOfTheFramework) {
    const BuildResult result =
        build("BumpySphere.cpp",
              reference("BumpySphere.cpp") +
                  "namespace raytracer { double randomBetween(double, double) { return 0.5; } }\n");
    EXPECT_EQ(result.kind, Kind::forbidden) << result.diagnostics;
}

TEST(Build, SeesNothingOfTheOtherFileOrOfThisMachine) {
    for (const char* include : {"Renderer.cpp", "/etc/passwd", TICKER_SOURCE_DIR "/LICENSE"}) {
        const BuildResult result =
            build("BumpySphere.cpp", std::string{"#include \""} + include + "\"\n");
        EXPECT_EQ(result.kind, Kind::failed) << include;
        // Level A does not have the file; at the other levels it cannot be opened.
        const bool isThere =
            include[0] == '/' && sandbox::Sandbox::best().level() != sandbox::Level::namespaces;
        EXPECT_NE(result.diagnostics.find(isThere ? "Permission denied" : "No such file"),
                  std::string::npos)
            << result.diagnostics;
    }
}

TEST(Build, StopsACompilerThatPrintsTooMuch) {
    std::string source;
    for (int i = 0; i < 2000; ++i)
        source += "#warning " + std::string(100, 'x') + "\n";
    const BuildResult result = build("Renderer.cpp", source);
    EXPECT_EQ(result.kind, Kind::limit);
    EXPECT_LT(result.diagnostics.size(), 20'000U);
}

TEST(Build, StopsACompilerThatTakesTooLong) {
    const std::string bomb =
        "#define A x, x, x, x, x, x, x, x\n#define B A, A, A, A, A, A, A, A\n"
        "#define C B, B, B, B, B, B, B, B\n#define D C, C, C, C, C, C, C, C\n"
        "#define E D, D, D, D, D, D, D, D\n#define F E, E, E, E, E, E, E, E\n"
        "#define G F, F, F, F, F, F, F, F\n#define H G, G, G, G, G, G, G, G\n"
        "int x;\nint y[] = {H, H, H, H, H, H, H, H};\n";
    static const Kit kit = Kit::besideProgram();
    sandbox::Limits limits = sandbox::defaultPolicy().compile;
    limits.cpuSeconds = 2.0;
    limits.addressSpaceBytes = 600'000'000;
    const BuildResult macros = buildProgram(kit, theSandbox(), limits, "Renderer.cpp", bomb);
    EXPECT_EQ(macros.kind, Kind::limit) << macros.diagnostics;
    // The compiler's own limit on loops in constant expressions ends this one: an ordinary error.
    const char* loop =
        "constexpr int f() { for (int i = 0;; i ^= 1) {} }\nstatic_assert(f() > 0);\n";
    EXPECT_EQ(build("Renderer.cpp", loop).kind, Kind::failed);
}

// The outcome of a compiler whose driver reports a killed compiler. A file can print the same text.
sandbox::Outcome saysThatItWasKilled(std::uint64_t peakMemoryBytes, bool machineRanOut) {
    sandbox::Outcome outcome;
    outcome.end = sandbox::Outcome::End::exited;
    outcome.code = 1;
    outcome.output =
        "g++: fatal error: Killed signal terminated program cc1plus\ncompilation terminated.\n";
    outcome.peakMemoryBytes = peakMemoryBytes;
    outcome.machineRanOut = machineRanOut;
    return outcome;
}

TEST(Build, BlamesTheMachineForAKilledCompilerOnlyIfOtherProcessesUsedTheMemory) {
    const sandbox::Limits& limits = sandbox::defaultPolicy().compile;
    EXPECT_EQ(kindOf(saysThatItWasKilled(200'000'000, true), limits), Kind::ourFault);
    EXPECT_EQ(kindOf(saysThatItWasKilled(1'500'000'000, true), limits), Kind::limit);
    EXPECT_EQ(kindOf(saysThatItWasKilled(200'000'000, false), limits), Kind::limit);
}

TEST(Build, DoesNotBelieveAFileThatSpeaksOfALostCompiler) {
    const BuildResult result = build("Renderer.cpp",
                                     "#line 1 \"nowhere\"\n"
                                     "#pragma message \"\\ng++: fatal error: Killed signal "
                                     "terminated program cc1plus\"\n#error stop\n");
    EXPECT_EQ(result.kind, Kind::limit) << result.diagnostics;
}

TEST(Build, TakesAnyBytesAsSource) {
    std::string source = reference("Renderer.cpp");
    source += "// \xFF\xFE \xC3\x28 latin-1: \xE9\n";
    EXPECT_EQ(build("Renderer.cpp", source).kind, Kind::built);
    source += "const char* \xE9 = 3;\n";
    EXPECT_EQ(build("Renderer.cpp", source).kind, Kind::failed);
}

}  // namespace
}  // namespace ticker::build
