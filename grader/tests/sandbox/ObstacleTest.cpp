#include <grader/sandbox/Obstacle.h>

#include <gtest/gtest.h>

namespace ticker::sandbox {
namespace {

TEST(Obstacle, IsRemovedByOneCommandThatFitsTheMachine) {
    EXPECT_EQ(commandForNamespaces({}), "");
    EXPECT_EQ(commandForNamespaces({.hasBubblewrap = false}), "apt-get install bubblewrap");
    EXPECT_EQ(commandForNamespaces({.unprivilegedClone = "0"}),
              "sysctl -w kernel.unprivileged_userns_clone=1");
    EXPECT_EQ(commandForNamespaces({.mostUserNamespaces = "0"}),
              "sysctl -w user.max_user_namespaces=10000");
    EXPECT_EQ(commandForNamespaces({.apparmorRestricts = "1"}),
              "sysctl -w kernel.apparmor_restrict_unprivileged_userns=0");
    EXPECT_NE(commandForNamespaces({.isContainer = true, .apparmorRestricts = "1"})
                  .find("seccomp=unconfined"),
              std::string::npos);
    EXPECT_EQ(
        commandForNamespaces(
            {.unprivilegedClone = "1", .apparmorRestricts = "0", .mostUserNamespaces = "63000"}),
        "");
}

TEST(Obstacle, IsNamedWithItsCommandAlone) {
    EXPECT_EQ(adviceForNamespaces({.unprivilegedClone = "0", .apparmorRestricts = "1"}),
              "run: sysctl -w kernel.unprivileged_userns_clone=1");
    EXPECT_EQ(adviceForNamespaces({}),
              "needs bubblewrap 0.8 or later and unprivileged user namespaces");
}

}  // namespace
}  // namespace ticker::sandbox
