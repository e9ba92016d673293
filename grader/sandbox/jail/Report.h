#ifndef TICKER_SANDBOX_JAIL_REPORT_H
#define TICKER_SANDBOX_JAIL_REPORT_H

#include <cstdint>

namespace ticker::jail {

/// The helper's report about the command's end, written in one piece. Both ends run on one machine,
/// so it is sent as it lies in memory.
struct Report {
    static constexpr std::uint32_t kMagic = 0x4c49414aU;
    enum class Kind : std::uint32_t { exited = 1, signalled = 2, setupFailed = 3 };

    std::uint32_t magic = kMagic;
    Kind kind = Kind::setupFailed;
    std::int32_t code = 0;  ///< exit status, signal, or errno
    std::uint32_t productsMissing = 0;
    std::uint64_t cpuMicroseconds = 0;  ///< of the command and all its descendants together
    std::uint64_t peakMemoryBytes = 0;  ///< of the largest single process
    char step[40] = {};                 ///< the step that failed, if kind is setupFailed
};

}  // namespace ticker::jail

#endif
