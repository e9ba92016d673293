#include "Trick.h"

#include <grader/sandbox/jail/Report.h>

#include <arpa/inet.h>
#include <dirent.h>
#include <fcntl.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace tricks {
namespace {

int result(bool worked) {
    return worked ? kSucceeded : kRefused;
}

int daemonise(std::span<char*>) {
    if (fork() != 0) _exit(0);
    setsid();
    if (fork() != 0) _exit(0);
    while (true)
        pause();
}

int killParent(std::span<char*>) {
    kill(getppid(), SIGKILL);
    return result(true);
}

int killAll(std::span<char*>) {
    kill(-1, SIGKILL);
    return result(true);
}

// By any number that the kernel reads as SIGKILL: it takes the lower half.
int killItself(std::span<char*> arguments) {
    const long number = std::strtol(arguments[0], nullptr, 0);
    return result(syscall(SYS_tgkill, getpid(), gettid(), number) == 0);
}

int traceParent(std::span<char*>) {
    return result(ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) == 0);
}

int internetSocket(std::span<char*>) {
    return result(socket(AF_INET, SOCK_STREAM, 0) >= 0);
}

int abstractSocket(std::span<char*>) {
    return result(socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
}

int readFile(std::span<char*> arguments) {
    const int file = open(arguments[0], O_RDONLY);
    if (file < 0) return kRefused;
    char text[256] = {};
    const ssize_t size = read(file, text, sizeof text);
    if (size > 0) write(1, text, static_cast<std::size_t>(size));
    return kSucceeded;
}

int writeFile(std::span<char*> arguments) {
    const int file = open(arguments[0], O_WRONLY | O_CREAT, 0666);
    return result(file >= 0 && write(file, "x", 1) == 1);
}

// Size, owner and times by the path; a flag says that the path may be empty.
int fileStatus(std::span<char*> arguments) {
    struct stat status {};
    struct statx more {};
    return result(syscall(SYS_newfstatat, AT_FDCWD, arguments[0], &status, AT_EMPTY_PATH) == 0 ||
                  syscall(SYS_newfstatat, AT_FDCWD, arguments[0], &status, 0) == 0 ||
                  syscall(SYS_statx, AT_FDCWD, arguments[0], AT_EMPTY_PATH, STATX_ALL, &more) == 0);
}

int listFolder(std::span<char*> arguments) {
    DIR* folder = opendir(arguments[0]);
    return result(folder != nullptr);
}

int makeLink(std::span<char*> arguments) {
    return result(symlink("/etc/passwd", arguments[0]) == 0);
}

// Writes a forged report of success to every descriptor.
int forgeReport(std::span<char*>) {
    ticker::jail::Report forged;
    forged.kind = ticker::jail::Report::Kind::exited;
    for (int descriptor = 3; descriptor < 1024; ++descriptor)
        if (write(descriptor, &forged, sizeof forged) >= 0) return kSucceeded;
    return 7;
}

int newNamespaces(std::span<char*>) {
    return result(unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0);
}

int ioUring(std::span<char*>) {
    char parameters[256] = {};
    return result(syscall(SYS_io_uring_setup, 8, parameters) >= 0);
}

int memoryFile(std::span<char*>) {
    return result(memfd_create("x", 0) >= 0);
}

int otherProgram(std::span<char*>) {
    char shell[] = "/bin/sh";
    char* const words[] = {shell, nullptr};
    execv(shell, words);
    return kRefused;
}

int typeIntoTerminal(std::span<char*>) {
    return result(ioctl(0, TIOCSTI, "x") == 0);
}

// The 32-bit entry, where call numbers mean something else: 2 is fork.
int otherArchitecture(std::span<char*>) {
#if defined(__x86_64__)
    int number = 2;
    asm volatile("int $0x80" : "+a"(number) : : "memory");
    return result(number >= 0);
#else
    return kRefused;
#endif
}

int becomeRoot(std::span<char*>) {
    return result(setresuid(0, 0, 0) == 0);
}

constexpr Trick kPryingTricks[] = {{"daemon", daemonise},
                                   {"kill-parent", killParent},
                                   {"kill-all", killAll},
                                   {"kill-itself", killItself},
                                   {"trace-parent", traceParent},
                                   {"internet-socket", internetSocket},
                                   {"abstract-socket", abstractSocket},
                                   {"read-file", readFile},
                                   {"write-file", writeFile},
                                   {"file-status", fileStatus},
                                   {"list-folder", listFolder},
                                   {"make-link", makeLink},
                                   {"forge-report", forgeReport},
                                   {"new-namespaces", newNamespaces},
                                   {"io-uring", ioUring},
                                   {"memory-file", memoryFile},
                                   {"other-program", otherProgram},
                                   {"type-into-terminal", typeIntoTerminal},
                                   {"other-architecture", otherArchitecture},
                                   {"become-root", becomeRoot}};

}  // namespace

std::span<const Trick> prying() {
    return kPryingTricks;
}

}  // namespace tricks
