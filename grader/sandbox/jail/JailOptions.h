#ifndef TICKER_SANDBOX_JAIL_JAILOPTIONS_H
#define TICKER_SANDBOX_JAIL_JAILOPTIONS_H

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::jail {

/// The helper writes its report to this descriptor.
inline constexpr int kStatusDescriptor = 63;
/// The lock on the command's uid, if it has one of its own. The helper never uses it: while the
/// helper runs, no other job gets the uid whose processes it will kill.
inline constexpr int kUserLockDescriptor = 62;
/// Lower numbers are the command's descriptors; from here up to the lock are products.
inline constexpr int kFirstProductDescriptor = 32;

enum class Filter { none, compile, run };

/// A file in the command's scratch folder that is copied to a descriptor after the command has
/// ended.
struct Product {
    std::string name;
    int descriptor = -1;
};

/// All options of `ticker-jail`. A limit of 0 is not set; an id of -1 is not changed.
struct Options {
    long user = -1;    ///< uid and gid of the command
    long parent = -1;  ///< pid of the parent; without it the helper exits
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
    std::vector<std::string> readOnly;  ///< paths that Landlock allows to read and execute
    std::vector<int> descriptors;       ///< kept open in addition to 0, 1 and 2
    std::vector<Product> products;
    std::vector<std::string> command;
};

/// The helper's command line for these options, without argv[0].
[[nodiscard]] std::vector<std::string> toArguments(const Options& options);

/// The inverse of toArguments. `error` names the first word that was not understood; empty if none.
struct ParsedOptions {
    Options options;
    std::string error;
};
[[nodiscard]] ParsedOptions parseOptions(const std::vector<std::string_view>& arguments);

}  // namespace ticker::jail

#endif
