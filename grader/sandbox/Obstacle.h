#ifndef TICKER_SANDBOX_OBSTACLE_H
#define TICKER_SANDBOX_OBSTACLE_H

#include <string>

namespace ticker::sandbox {

/// What decides whether a program may make namespaces, which level A needs.
struct NamespaceSettings {
    bool hasBubblewrap = true;
    bool isContainer = false;
    std::string unprivilegedClone = {};  ///< kernel.unprivileged_userns_clone; empty: not there
    std::string apparmorRestricts = {};  ///< kernel.apparmor_restrict_unprivileged_userns; likewise
    std::string mostUserNamespaces = {};  ///< user.max_user_namespaces; likewise
};

/// Read from this machine.
[[nodiscard]] NamespaceSettings namespaceSettings();

/// The one command that removes the first obstacle to level A; empty if none of those known is
/// there.
[[nodiscard]] std::string commandForNamespaces(const NamespaceSettings& settings);

/// What level A needs here, for people: that command where there is one.
[[nodiscard]] std::string adviceForNamespaces(const NamespaceSettings& settings);

}  // namespace ticker::sandbox

#endif
