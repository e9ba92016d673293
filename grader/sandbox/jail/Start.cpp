#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/jail/Lockdown.h>
#include <grader/sandbox/jail/Start.h>

#include <fcntl.h>
#include <grp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace ticker::jail {
namespace {

Failure changeUser(long user) {
    if (user < 0) return nullptr;
    const uid_t id = static_cast<uid_t>(user);
    if (setgroups(0, nullptr) != 0) return "setgroups";
    if (setresgid(id, id, id) != 0) return "setresgid";
    if (setresuid(id, id, id) != 0) return "setresuid";
    return nullptr;
}

// The kernel clears the parent-death signal when a process changes its uid, so set it afterwards.
Failure dieWithParent(pid_t parent) {
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return "prctl pdeathsig";
    if (getppid() != parent) _exit(125);
    return nullptr;
}

Failure closeOtherDescriptors(const Options& options, int keepOpen) {
    std::vector<int> kept{0, 1, 2, keepOpen};
    kept.insert(kept.end(), options.descriptors.begin(), options.descriptors.end());
    std::sort(kept.begin(), kept.end());
    unsigned first = 0;
    for (const int descriptor : kept) {
        const unsigned next = static_cast<unsigned>(descriptor);
        if (next > first && close_range(first, next - 1, 0) != 0) return "close_range";
        first = std::max(first, next + 1);
    }
    return close_range(first, ~0U, 0) == 0 ? nullptr : "close_range";
}

Failure changeFolder(const Options& options) {
    if (options.folder.empty() || chdir(options.folder.c_str()) == 0) return nullptr;
    return "chdir";
}

void resetSignals() {
    struct sigaction action {};
    action.sa_handler = SIG_DFL;
    for (int signal = 1; signal < NSIG; ++signal)
        sigaction(signal, &action, nullptr);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

// Sets the identity: uid, session, working directory and descriptors.
Failure changeIdentity(const Options& options, pid_t parent, int keepOpen) {
    if (setsid() < 0) return "setsid";
    if (Failure failure = changeUser(options.user)) return failure;
    if (Failure failure = dieWithParent(parent)) return failure;
    if (Failure failure = closeOtherDescriptors(options, keepOpen)) return failure;
    return changeFolder(options);
}

// Gives up rights: from now on only what the options allow.
Failure giveUpRights(const Options& options) {
    resetSignals();
    if (options.filter != Filter::none || options.landlock) {
        if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return "no_new_privs";
    }
    if (Failure failure = restrictFiles(options)) return failure;
    if (Failure failure = limitResources(options)) return failure;
    return restrictSystemCalls(options.filter);
}

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> result;
    for (std::string& word : words)
        result.push_back(word.data());
    result.push_back(nullptr);
    return result;
}

// Errors of execve for a file that exists but cannot be executed, or whose interpreter is missing:
// a student can produce such a file, so this is not an error of the sandbox.
bool isUnfit(int error) {
    return error == ENOEXEC || error == ENOENT || error == EACCES || error == ENOMEM ||
           error == EINVAL || error == ELIBBAD;
}

}  // namespace

StartFailure becomeCommand(const Options& options, pid_t parent, int keepOpen) {
    // Allocate before the limits are set: afterwards no memory may be left.
    std::vector<std::string> words = options.command;
    std::vector<std::string> settings{"PATH=/usr/bin:/bin", "LC_ALL=C"};
    if (!options.scratch.empty()) settings.push_back("TMPDIR=" + options.scratch);
    const std::vector<char*> argv = pointers(words);
    const std::vector<char*> environment = pointers(settings);

    Failure step = changeIdentity(options, parent, keepOpen);
    const bool isThere = step == nullptr && access(argv[0], X_OK) == 0;
    if (step == nullptr) step = giveUpRights(options);
    if (step == nullptr) {
        execve(argv[0], argv.data(), environment.data());
        if (isThere && isUnfit(errno)) _exit(sandbox::kNotExecutable);
        step = "execve";
    }
    StartFailure failure;
    failure.error = errno;
    std::strncpy(failure.step, step, sizeof failure.step - 1);
    return failure;
}

}  // namespace ticker::jail
