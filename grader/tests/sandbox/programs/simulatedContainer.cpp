// simulated_container [--docker | --user UID] [--no-namespaces] [--copy FILE]... -- PROGRAM
// ARGUMENT... Runs PROGRAM in a simulated environment. --docker: as root with the capabilities that
// Docker leaves by default, and without its namespaces; --user: as an ordinary user;
// --no-namespaces: the kernel refuses new namespaces. --copy: into a folder that every user can
// reach, where PROGRAM is then searched; it is removed at the end.
#include <fcntl.h>
#include <grp.h>
#include <linux/capability.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr int kSkipped = 77;

struct Plan {
    bool docker = false;
    bool noNamespaces = false;
    long user = -1;
    std::vector<fs::path> copies;
    std::vector<char*> command;
};

[[noreturn]] void fail(const char* what) {
    std::perror(what);
    std::_Exit(125);
}

Plan parse(int count, char** words) {
    Plan plan;
    int at = 1;
    for (; at < count && std::string_view{words[at]} != "--"; ++at) {
        const std::string_view word = words[at];
        if (word == "--docker") plan.docker = plan.noNamespaces = true;
        if (word == "--no-namespaces") plan.noNamespaces = true;
        if (word == "--user") plan.user = std::atol(words[++at]);
        if (word == "--copy") plan.copies.emplace_back(words[++at]);
    }
    for (++at; at < count; ++at)
        plan.command.push_back(words[at]);
    plan.command.push_back(nullptr);
    return plan;
}

bool refuse(scmp_filter_ctx filter, int call) {
    return seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), call, 0) == 0;
}

// What Docker's default seccomp profile refuses to a container without CAP_SYS_ADMIN, as far as a
// sandbox could want it.
void refuseNamespaces() {
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ALLOW);
    bool done = filter != nullptr && seccomp_attr_set(filter, SCMP_FLTATR_CTL_NNP, 0) == 0;
    for (const int call :
         {SCMP_SYS(unshare), SCMP_SYS(mount), SCMP_SYS(umount2), SCMP_SYS(setns),
          SCMP_SYS(pivot_root), SCMP_SYS(bpf), SCMP_SYS(perf_event_open), SCMP_SYS(keyctl),
          SCMP_SYS(add_key), SCMP_SYS(open_tree), SCMP_SYS(move_mount), SCMP_SYS(fsopen)})
        done = done && refuse(filter, call);
    constexpr std::uint64_t kNamespaces[] = {CLONE_NEWNS,    CLONE_NEWUSER, CLONE_NEWPID,
                                             CLONE_NEWNET,   CLONE_NEWIPC,  CLONE_NEWUTS,
                                             CLONE_NEWCGROUP};
    for (const std::uint64_t space : kNamespaces) {
        const scmp_arg_cmp wanted{0, SCMP_CMP_MASKED_EQ, space, space};
        done = done && seccomp_rule_add_array(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1,
                                              &wanted) == 0;
    }
    done = done && seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0) == 0;
    if (!done || seccomp_load(filter) != 0) fail("seccomp");
    seccomp_release(filter);
}

void keepDockerCapabilities() {
    std::uint64_t kept = 0;
    for (const int capability :
         {CAP_CHOWN, CAP_DAC_OVERRIDE, CAP_FOWNER, CAP_FSETID, CAP_KILL, CAP_SETGID, CAP_SETUID,
          CAP_SETPCAP, CAP_NET_BIND_SERVICE, CAP_NET_RAW, CAP_SYS_CHROOT, CAP_MKNOD,
          CAP_AUDIT_WRITE, CAP_SETFCAP})
        kept |= std::uint64_t{1} << static_cast<unsigned>(capability);
    for (unsigned capability = 0; capability < 64; ++capability)
        if (((kept >> capability) & 1U) == 0) prctl(PR_CAPBSET_DROP, capability, 0, 0, 0);
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    const std::uint32_t low = static_cast<std::uint32_t>(kept);
    const std::uint32_t high = static_cast<std::uint32_t>(kept >> 32U);
    const __user_cap_data_struct data[2] = {{low, low, 0}, {high, high, 0}};
    if (syscall(SYS_capset, &header, data) != 0) fail("capset");
}

void become(const Plan& plan) {
    if (plan.noNamespaces) refuseNamespaces();
    if (plan.docker) keepDockerCapabilities();
    if (plan.user < 0) return;
    const uid_t id = static_cast<uid_t>(plan.user);
    if (setgroups(0, nullptr) != 0 || setresgid(id, id, id) != 0 || setresuid(id, id, id) != 0)
        fail("setuid");
}

fs::path copyFiles(const Plan& plan) {
    std::string folder = "/tmp/simulated-container-XXXXXX";
    if (mkdtemp(folder.data()) == nullptr) fail("mkdtemp");
    fs::permissions(folder, fs::perms{0755});
    for (const fs::path& file : plan.copies) {
        fs::copy_file(file, fs::path{folder} / file.filename());
        fs::permissions(fs::path{folder} / file.filename(), fs::perms{0755});
    }
    return folder;
}

}  // namespace

int main(int count, char** words) {
    Plan plan = parse(count, words);
    if (plan.command.front() == nullptr) return 2;
    if (geteuid() != 0) {
        std::puts("skipped: only root can take the part of a container's root or of another user");
        return kSkipped;
    }
    const fs::path folder = copyFiles(plan);
    fs::path program = folder / plan.command.front();
    if (!fs::exists(program)) program = plan.command.front();
    const pid_t child = fork();
    if (child == 0) {
        if (chdir("/") != 0) fail("chdir");
        become(plan);
        execv(program.c_str(), plan.command.data());
        fail("exec");
    }
    int status = 0;
    waitpid(child, &status, 0);
    fs::remove_all(folder);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
