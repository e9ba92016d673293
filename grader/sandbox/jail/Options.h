#ifndef TICKER_SANDBOX_JAIL_OPTIONS_H
#define TICKER_SANDBOX_JAIL_OPTIONS_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::jail {

/// Where the helper writes its report.
inline constexpr int kStatusDescriptor = 63;
/// Descriptors below are for commands; from here up to the status are products.
inline constexpr int kFirstProductDescriptor = 32;

enum class Filter { none, compile, run };

/// A file that the command leaves in its scratch folder, copied to a descriptor afterwards.
struct Product {
    std::string name;
    int descriptor = -1;
};

/// All that `ticker-jail` is told. A limit of 0 is not set; an id of -1 is not changed.
struct Options {
    long user = -1;    ///< uid and gid of the command
    long parent = -1;  ///< pid without which there is no reason to live
    bool reports = false;
    bool landlock = false;
    Filter filter = Filter::none;
    std::uint64_t cpuSeconds = 0;
    std::uint64_t addressSpaceBytes = 0;
    std::uint64_t fileSizeBytes = 0;
    std::uint64_t stackBytes = 0;
    std::uint64_t processes = 0;
    std::uint64_t openFiles = 0;
    std::string folder;                 ///< working directory; empty: unchanged
    std::string scratch;                ///< writable folder; empty: none
    std::vector<std::string> readOnly;  ///< what Landlock lets be read and executed
    std::vector<int> descriptors;       ///< kept open beside 0, 1 and 2
    std::vector<Product> products;
    std::vector<std::string> command;
};

/// The helper's command line, without argv[0].
[[nodiscard]] std::vector<std::string> toArguments(const Options& options);

/// The reverse of toArguments. `error` names the word that was not understood; empty if none.
struct ParsedOptions {
    Options options;
    std::string error;
};
[[nodiscard]] ParsedOptions parseOptions(const std::vector<std::string_view>& arguments);

}  // namespace ticker::jail

#endif
