#ifndef TICKER_SANDBOX_HELPERPROGRAM_H
#define TICKER_SANDBOX_HELPERPROGRAM_H

#include <filesystem>

namespace ticker::sandbox {

/// `ticker-jail` beside the running program, or in ../libexec/ticker from there.
/// @throws raytracer::Error where it is in neither place.
[[nodiscard]] std::filesystem::path findHelper();

/// bubblewrap: /usr/bin/bwrap, /usr/local/bin/bwrap or on the PATH; empty where there is none.
[[nodiscard]] std::filesystem::path findBubblewrap();

}  // namespace ticker::sandbox

#endif
