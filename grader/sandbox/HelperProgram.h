#ifndef TICKER_SANDBOX_HELPERPROGRAM_H
#define TICKER_SANDBOX_HELPERPROGRAM_H

#include <filesystem>
#include <string>

namespace ticker::sandbox {

/// Finds one of our static programs, such as `ticker-jail`: beside the running program, or in
/// ../libexec/ticker from there.
/// @throws raytracer::Error if it is in neither place.
[[nodiscard]] std::filesystem::path findProgram(const std::string& name);

/// Finds bubblewrap: /usr/bin/bwrap, /usr/local/bin/bwrap or on the PATH; empty if it is not
/// installed.
[[nodiscard]] std::filesystem::path findBubblewrap();

}  // namespace ticker::sandbox

#endif
