#ifndef TICKER_ORACLE_TILES_H
#define TICKER_ORACLE_TILES_H

#include <grader/oracle/kernel/Workspace.h>

#include <raytracer/base/RenderSettings.h>

#include <functional>

namespace ticker::oracle {

/// A run of pixels of the rendered region, row-major, that one thread works on at a time.
struct Tile {
    int number = 0;
    int first = 0;
    int end = 0;
};

/// Calls `work` for every tile of `pixels` pixels, on `threads` threads, each with its own
/// workspace. Tiles do not depend on the number of threads. Stops handing out tiles once the
/// monitor says that it is interrupted. An exception of `work` comes out of this call.
/// @return  False where it was interrupted.
bool forEachTile(int pixels, int threads, raytracer::RenderMonitor* monitor,
                 const std::function<void(const Tile&, Workspace&)>& work);

}  // namespace ticker::oracle

#endif
