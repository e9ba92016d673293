#ifndef RAYTRACER_APP_SYSTEM_H
#define RAYTRACER_APP_SYSTEM_H

#include <filesystem>
#include <optional>

namespace raytracer {

// All that differs between Unix and Windows.

/// What a program's messages go to.
enum class Stream { out, error };

/// True if a person sees the stream at once; false for files and pipes. On Windows this also makes
/// the console understand UTF-8 and the escape sequences of colours.
[[nodiscard]] bool isTerminal(Stream stream);

/// Size of a terminal's window in characters.
struct WindowSize {
    int columns = 80;
    int lines = 24;
};

/// Empty where the stream is no terminal or has no size.
[[nodiscard]] std::optional<WindowSize> windowSize(Stream stream);

/// True if the system's terminals understand escape sequences without TERM saying so.
[[nodiscard]] bool terminalsNeedNoTerm();

/// The running program's file; empty where the system does not tell.
[[nodiscard]] std::filesystem::path programFile();

}  // namespace raytracer

#endif
