#ifndef TICKER_BASE_UTCTEXT_H
#define TICKER_BASE_UTCTEXT_H

#include <array>
#include <ctime>
#include <string>

namespace ticker {

/// A time in UTC: "2026-11-21T16:05:36Z".
[[nodiscard]] inline std::string utcText(std::time_t time) {
    std::tm parts{};
    gmtime_r(&time, &parts);
    std::array<char, 64> text{};
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

}  // namespace ticker

#endif
