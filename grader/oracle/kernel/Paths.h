#ifndef TICKER_ORACLE_PATHS_H
#define TICKER_ORACLE_PATHS_H

#include <grader/oracle/Setup.h>
#include <grader/oracle/kernel/Workspace.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace ticker::oracle {

/// Packs the paths of many pixels into a workspace without gaps, so that no lane idles at the end
/// of a pixel.
///
/// `Flush` is called as flush(workspace, runs) whenever the workspace is full and once at the end.
class PathPacker {
public:
    /// Paths [first, end) of the workspace belong to one pixel.
    struct Run {
        int pixel;
        std::size_t first, end;
    };

    PathPacker(const Setup& setup, Workspace& work) : setup_(setup), work_(work) {
        work_.paths = 0;
    }

    /// Adds paths 0 to count - 1 of a pixel. `key` selects their randomisation.
    template <typename Flush>
    void add(int pixel, std::uint32_t key, std::uint32_t count, const Flush& flush) {
        for (std::uint32_t done = 0; done < count;) {
            if (work_.paths == kPaths) finish(flush);
            const std::size_t first = work_.paths;
            const std::size_t end = first + std::min<std::size_t>(count - done, kPaths - first);
            fill(pixel, key, done, first, end);
            runs_.push_back({pixel, first, end});
            work_.paths = end;
            done += static_cast<std::uint32_t>(end - first);
        }
    }

    /// Flushes the remaining paths.
    template <typename Flush>
    void finish(const Flush& flush) {
        if (work_.paths != 0) flush(work_, std::as_const(runs_));
        runs_.clear();
        work_.paths = 0;
    }

private:
    void fill(int pixel, std::uint32_t key, std::uint32_t sample, std::size_t first,
              std::size_t end) {
        const std::int32_t column = pixel % setup_.width;
        const std::int32_t row = pixel / setup_.width;
        for (std::size_t at = first; at < end; ++at) {
            work_.column[at] = column;
            work_.row[at] = row;
            work_.sample[at] = sample++;
            work_.randomisation[at] = key;
        }
    }

    const Setup& setup_;
    Workspace& work_;
    std::vector<Run> runs_;
};

}  // namespace ticker::oracle

#endif
