#include <raytracer/serve/Door.h>

#include <gtest/gtest.h>

#include <set>

namespace raytracer {
namespace {

TEST(Door, KnowsItsOwnHostAlone) {
    EXPECT_TRUE(namesThisServer("127.0.0.1:80", 80));
    EXPECT_TRUE(namesThisServer("localhost:80", 80));
    for (const char* host : {"", "127.0.0.1", "127.0.0.1:81", "evil.example:80",
                             "127.0.0.1:80.evil", "127.0.0.1.evil.example:80"})
        EXPECT_FALSE(namesThisServer(host, 80)) << host;
}

TEST(Door, TellsSecretsApart) {
    EXPECT_TRUE(isSameSecret("abc", "abc"));
    EXPECT_FALSE(isSameSecret("abc", "abd"));
    EXPECT_FALSE(isSameSecret("abc", "ab"));
    EXPECT_FALSE(isSameSecret("", "a"));
}

TEST(Door, GivesAnotherTokenEachTime) {
    std::set<std::string> tokens;
    for (int i = 0; i < 20; ++i)
        tokens.insert(freshToken());
    EXPECT_EQ(tokens.size(), 20U);
    for (const std::string& token : tokens)
        EXPECT_TRUE(isToken(token)) << token;
    EXPECT_FALSE(isToken("../../etc"));
}

TEST(Door, LetsThePageInAndNoOther) {
    const std::string token = freshToken();
    const RequestHead read{"GET", "/" + token + "/x", "127.0.0.1:80", "", ""};
    const RequestHead change{"POST", "/" + token + "/x", "127.0.0.1:80", "http://127.0.0.1:80",
                             token};
    EXPECT_TRUE(mayEnter(read, token, 80));
    EXPECT_TRUE(mayEnter(change, token, 80));
    EXPECT_FALSE(mayEnter({"GET", "/", "127.0.0.1:80", "", ""}, token, 80)) << "no token";
    EXPECT_FALSE(mayEnter({"GET", "", "127.0.0.1:80", "", ""}, token, 80)) << "no path";
    EXPECT_FALSE(mayEnter({"GET", read.path, "evil.example", "", ""}, token, 80)) << "rebinding";
    EXPECT_FALSE(
        mayEnter({"POST", change.path, change.host, "http://evil.example", token}, token, 80));
    EXPECT_FALSE(mayEnter({"POST", change.path, change.host, change.origin, ""}, token, 80));
    EXPECT_FALSE(mayEnter({"DELETE", change.path, change.host, change.origin, token}, token, 80));
}

}  // namespace
}  // namespace raytracer
