#ifndef TOOLS_MAKE_ASSETS_LETTERASSET_H
#define TOOLS_MAKE_ASSETS_LETTERASSET_H

#include <raytracer/io/ImageReader.h>

namespace assets {

/// bumpmap-test.png: raised (bright) letters H and lowered (dark) letters L on mid grey.
///
/// 2048 x 1024 texels, so that texels are square at the sphere's equator and letters keep their
/// proportions there. No letter touches the left or right edge, where the map wraps around, and
/// none lies near the poles. The edges of the letters are bevelled, so that slopes are finite.
[[nodiscard]] raytracer::ByteImage makeLetterMap();

}  // namespace assets

#endif
