#include <grader/session/Access.h>
#include <grader/tests/support/AsNobody.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <set>

namespace ticker::session {
namespace {

namespace fs = std::filesystem;

TEST(Access, IsAnotherEachTimeUnlessItWasKept) {
    const tests::TemporaryFolder out;
    std::set<std::string> tokens;
    for (int i = 0; i < 20; ++i)
        tokens.insert(readAccess(out.path()).token);
    EXPECT_EQ(tokens.size(), 20U);
    EXPECT_EQ(tokens.begin()->size(), 32U);
    const Access access{*tokens.begin(), 4711};
    writeAccess(access, out.path());
    EXPECT_EQ(readAccess(out.path()).token, access.token);
    EXPECT_EQ(readAccess(out.path()).port, 4711);
}

TEST(Access, IsForItsOwnerAlone) {
    const tests::TemporaryFolder out;
    const Access access = readAccess(out.path());
    writeAccess(access, out.path());
    const fs::path file = out.path() / ".session";
    EXPECT_EQ(fs::status(file).permissions(), fs::perms{0600});
    fs::permissions(file, fs::perms{0644});
    EXPECT_NE(readAccess(out.path()).token, access.token) << "others could have read it";
    fs::remove(file);
    out.write("elsewhere", "{\"token\": \"0123456789abcdef0123456789abcdef\", \"port\": 1}");
    fs::permissions(out.path() / "elsewhere", fs::perms{0600});
    fs::create_symlink(out.path() / "elsewhere", file);
    EXPECT_NE(readAccess(out.path()).token, "0123456789abcdef0123456789abcdef");
}

TEST(Access, SaysWhyItCannotBeWritten) {
    const tests::TemporaryFolder out;
    const tests::AsNobody nobody;
    try {
        writeAccess({}, out.path());
        FAIL() << "it was written";
    } catch (const raytracer::InputError& error) {
        EXPECT_EQ(error.what(), (out.path() / ".session").string() +
                                    ": cannot be written: Permission denied; make room or rights "
                                    "in this folder");
    }
}

TEST(Access, SurvivesAnyFile) {
    const tests::TemporaryFolder out;
    for (const char* text :
         {"", "[]", "{\"token\": 7}", "{\"token\": \"../../etc\"}", "nonsense"}) {
        out.write(".session", text);
        fs::permissions(out.path() / ".session", fs::perms{0600});
        EXPECT_EQ(readAccess(out.path()).token.size(), 32U) << text;
    }
}

}  // namespace
}  // namespace ticker::session
