#ifndef RAYTRACER_APP_VIEW_PROCESS_H
#define RAYTRACER_APP_VIEW_PROCESS_H

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer::view {

/// Status of a program that cannot be started.
inline constexpr int kNotFound = 127;

/// A program that this one starts. It ends, with everything that it started itself, when this
/// object is destroyed, and when this program ends, even if it is killed.
class Process {
public:
    /// Where the program's stderr goes.
    enum class Errors { toOurs, withItsOutput };

    /// @param command  The program, looked up in PATH, and its arguments.
    /// @throws Error if the system gives no process or pipe. A program that cannot be started ends
    ///         at once with the status `kNotFound`.
    Process(const std::vector<std::string>& command, Errors errors);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Waits for the program's output. @return The number of bytes read; 0 at its end.
    [[nodiscard]] std::size_t read(char* bytes, std::size_t size);
    /// Writes to the program's stdin. False if the program reads no more.
    bool write(std::string_view bytes);
    /// Ends it and everything that it started; `read` then comes to the end. Another thread may
    /// call this.
    void kill();
    /// Waits for its end. @return Its exit status; above 128 where a signal or `kill` ended it,
    /// negative where it crashed on Windows.
    [[nodiscard]] int wait();

private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
};

/// The parent's pipes, in a program that was started as a `Process`: `read` gets what the parent
/// writes, and `write` sends to it.
class Parent {
public:
    /// Takes stdout away from the rest of the program, which writes to stderr from here on.
    Parent();

    [[nodiscard]] std::size_t read(char* bytes, std::size_t size);
    bool write(std::string_view bytes);

private:
    int in_;
    int out_;
};

/// Lets browser, compiler and the answers to questions go first: lowers the priority of this thread
/// and of those that it starts; of the whole program where the system has no priority of threads.
void yieldToOthers();

/// Makes room for a linker where the system lets no running program be replaced.
/// @return Where the program is now; empty where it was not moved.
[[nodiscard]] std::filesystem::path moveAside(const std::filesystem::path& program);

/// Opens an address in the browser where this is a desktop that can.
void openInBrowser(const std::string& address);

}  // namespace raytracer::view

#endif
