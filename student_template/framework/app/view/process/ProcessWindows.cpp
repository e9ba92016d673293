#ifdef _WIN32
#include "Process.h"

#include <raytracer/base/Error.h>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <fcntl.h>
#include <io.h>
#include <shellapi.h>

#include <array>
#include <mutex>
#include <system_error>

namespace raytracer::view {
namespace {

namespace fs = std::filesystem;

constexpr int kKilled = 137;

/// A command as one line, with the quotation marks that programs take off again.
std::string lineOf(const std::vector<std::string>& command) {
    std::string line;
    for (const std::string& word : command) {
        line += line.empty() ? "\"" : " \"";
        std::size_t slashes = 0;
        for (const char c : word) {
            if (c == '"') line.append(slashes + 1, '\\');
            slashes = c == '\\' ? slashes + 1 : 0;
            line += c;
        }
        line.append(slashes, '\\');
        line += '"';
    }
    return line;
}

struct Pipe {
    HANDLE read = nullptr;
    HANDLE write = nullptr;
};

Pipe makePipe() {
    SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
    Pipe pipe;
    if (CreatePipe(&pipe.read, &pipe.write, &inherited, 0) == 0)
        throw Error("the system gives no pipe");
    return pipe;
}

// Two starts at a time would hand each other's pipes on, which then never end.
std::mutex& starting() {
    static std::mutex mutex;
    return mutex;
}

/// A job whose processes end with its last handle: when this program ends, in whatever way.
HANDLE makeJob() {
    HANDLE job = CreateJobObjectA(nullptr, nullptr);
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
    SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof(limits));
    return job;
}

}  // namespace

struct Process::Handles {
    HANDLE process = nullptr;
    HANDLE job = nullptr;
    HANDLE in = nullptr;
    HANDLE out = nullptr;
};

Process::Process(const std::vector<std::string>& command, Errors errors)
    : handles_(std::make_unique<Handles>()) {
    const std::lock_guard lock{starting()};
    const Pipe in = makePipe();
    const Pipe out = makePipe();
    SetHandleInformation(in.write, HANDLE_FLAG_INHERIT, 0);
    SetHandleInformation(out.read, HANDLE_FLAG_INHERIT, 0);
    STARTUPINFOA start{};
    start.cb = sizeof(start);
    start.dwFlags = STARTF_USESTDHANDLES;
    start.hStdInput = in.read;
    start.hStdOutput = out.write;
    start.hStdError = errors == Errors::withItsOutput ? out.write : GetStdHandle(STD_ERROR_HANDLE);
    PROCESS_INFORMATION made{};
    std::string line = lineOf(command);
    handles_->job = makeJob();
    if (CreateProcessA(nullptr, line.data(), nullptr, nullptr, TRUE,
                       CREATE_SUSPENDED | CREATE_NEW_PROCESS_GROUP, nullptr, nullptr, &start,
                       &made) != 0) {
        AssignProcessToJobObject(handles_->job, made.hProcess);
        ResumeThread(made.hThread);
        CloseHandle(made.hThread);
        handles_->process = made.hProcess;
    }
    CloseHandle(in.read);
    CloseHandle(out.write);
    handles_->in = in.write;
    handles_->out = out.read;
}

Process::~Process() {
    kill();
    static_cast<void>(wait());
    for (HANDLE handle : {handles_->process, handles_->job, handles_->in, handles_->out})
        if (handle != nullptr) CloseHandle(handle);
}

std::size_t Process::read(char* bytes, std::size_t size) {
    DWORD got = 0;
    const BOOL worked = ReadFile(handles_->out, bytes, static_cast<DWORD>(size), &got, nullptr);
    return worked != 0 ? got : 0;
}

bool Process::write(std::string_view bytes) {
    while (!bytes.empty()) {
        DWORD written = 0;
        if (WriteFile(handles_->in, bytes.data(), static_cast<DWORD>(bytes.size()), &written,
                      nullptr) == 0)
            return false;
        bytes.remove_prefix(written);
    }
    return true;
}

void Process::kill() {
    TerminateJobObject(handles_->job, kKilled);
}

int Process::wait() {
    if (handles_->process == nullptr) return kNotFound;
    WaitForSingleObject(handles_->process, INFINITE);
    DWORD status = kKilled;
    GetExitCodeProcess(handles_->process, &status);
    return static_cast<int>(status);
}

Parent::Parent() : in_(_fileno(stdin)), out_(_dup(_fileno(stdout))) {
    _dup2(_fileno(stderr), _fileno(stdout));
    _setmode(in_, _O_BINARY);
    _setmode(out_, _O_BINARY);
}

std::size_t Parent::read(char* bytes, std::size_t size) {
    const int got = _read(in_, bytes, static_cast<unsigned>(size));
    return got > 0 ? static_cast<std::size_t>(got) : 0;
}

bool Parent::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const int written = _write(out_, bytes.data(), static_cast<unsigned>(bytes.size()));
        if (written <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

void yieldToOthers() {
    SetPriorityClass(GetCurrentProcess(), BELOW_NORMAL_PRIORITY_CLASS);
}

fs::path moveAside(const fs::path& program) {
    std::error_code error;
    for (int i = 0; i < 100; ++i) {
        fs::path aside = program;
        aside += "." + std::to_string(i) + ".old";
        fs::remove(aside, error);  // refused while it runs
        if (fs::exists(aside, error)) continue;
        fs::rename(program, aside, error);
        return error ? fs::path{} : aside;
    }
    return {};
}

void openInBrowser(const std::string& address) {
    ShellExecuteA(nullptr, "open", address.c_str(), nullptr, nullptr, SW_SHOWNORMAL);
}

}  // namespace raytracer::view
#endif
