#include "System.h"

#include <system_error>

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX  // Visual Studio's command line has it
#define NOMINMAX
#endif
#include <windows.h>
#include <array>
#else
#include <sys/ioctl.h>
#include <unistd.h>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#include <array>
#include <cstdint>
#endif
#endif

namespace raytracer {

#ifdef _WIN32

namespace {

HANDLE handleOf(Stream stream) {
    return GetStdHandle(stream == Stream::out ? STD_OUTPUT_HANDLE : STD_ERROR_HANDLE);
}

}  // namespace

bool isTerminal(Stream stream) {
    DWORD mode = 0;
    if (GetConsoleMode(handleOf(stream), &mode) == 0) return false;
    SetConsoleOutputCP(CP_UTF8);
    // Consoles before Windows 10 do not know this mode: they would show the sequences as text.
    return SetConsoleMode(handleOf(stream), mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING) != 0;
}

std::optional<WindowSize> windowSize(Stream stream) {
    CONSOLE_SCREEN_BUFFER_INFO info{};
    if (GetConsoleScreenBufferInfo(handleOf(stream), &info) == 0) return std::nullopt;
    return WindowSize{info.srWindow.Right - info.srWindow.Left + 1,
                      info.srWindow.Bottom - info.srWindow.Top + 1};
}

bool terminalsNeedNoTerm() {
    return true;
}

std::filesystem::path programFile() {
    constexpr DWORD kLongest = 4096;
    std::array<wchar_t, kLongest> name{};
    const DWORD length = GetModuleFileNameW(nullptr, name.data(), kLongest);
    if (length == 0 || length == kLongest) return {};
    return std::wstring(name.data(), length);
}

#else

namespace {

int numberOf(Stream stream) {
    return stream == Stream::out ? STDOUT_FILENO : STDERR_FILENO;
}

}  // namespace

bool isTerminal(Stream stream) {
    return isatty(numberOf(stream)) == 1;
}

std::optional<WindowSize> windowSize(Stream stream) {
    winsize size{};
    const bool isThere = ioctl(numberOf(stream), TIOCGWINSZ, &size) == 0;
    if (!isThere || size.ws_col == 0 || size.ws_row == 0) return std::nullopt;
    return WindowSize{size.ws_col, size.ws_row};
}

bool terminalsNeedNoTerm() {
    return false;
}

std::filesystem::path programFile() {
#ifdef __APPLE__
    std::array<char, 4096> name{};
    auto size = static_cast<std::uint32_t>(name.size());
    return _NSGetExecutablePath(name.data(), &size) == 0 ? name.data() : "";
#else
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error);
#endif
}

#endif

}  // namespace raytracer
