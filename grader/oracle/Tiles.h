#ifndef TICKER_ORACLE_TILES_H
#define TICKER_ORACLE_TILES_H

#include <grader/oracle/kernel/Workspace.h>

#include <raytracer/base/RenderSettings.h>

#include <functional>

namespace ticker::oracle {

/// A run of consecutive pixels of the rendered region, row-major, processed by one thread.
struct Tile {
    int number = 0;
    int first = 0;
    int end = 0;
};

/// Calls `work` for every tile of `pixels` pixels, on `threads` threads, each with its own
/// workspace. Tiles do not depend on the number of threads. No new tile starts after the monitor
/// reports an interrupt. An exception of `work` propagates to the caller.
/// @return  False if it was interrupted.
bool forEachTile(int pixels, int threads, raytracer::RenderMonitor* monitor,
                 const std::function<void(const Tile&, Workspace&)>& work);

}  // namespace ticker::oracle

#endif
