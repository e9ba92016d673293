#ifndef TICKER_SANDBOX_HELPERPROGRAM_H
#define TICKER_SANDBOX_HELPERPROGRAM_H

#include <filesystem>
#include <string>
#include <system_error>

namespace ticker::sandbox {

/// Finds one of our static programs, such as `ticker-jail`: beside the running program, or in
/// ../libexec/ticker from there.
/// @throws raytracer::Error if it is in neither place.
[[nodiscard]] std::filesystem::path findProgram(const std::string& name);

/// Copies one of them into `folder`, where every user may run it, and returns the copy: the jail's
/// user can then reach it wherever the project lies.
/// @throws raytracer::Error if it is missing or cannot be copied, as on a full disk.
[[nodiscard]] std::filesystem::path copyProgram(const std::string& name,
                                                const std::filesystem::path& folder);

/// What cannot be copied into a staging folder, and what to do about it.
[[nodiscard]] std::string cannotStage(const std::filesystem::path& what,
                                      const std::error_code& why);

/// Finds bubblewrap: /usr/bin/bwrap, /usr/local/bin/bwrap or on the PATH; empty if it is not
/// installed.
[[nodiscard]] std::filesystem::path findBubblewrap();

}  // namespace ticker::sandbox

#endif
