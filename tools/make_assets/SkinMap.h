#ifndef TOOLS_MAKE_ASSETS_SKINMAP_H
#define TOOLS_MAKE_ASSETS_SKINMAP_H

#include <raytracer/io/ImageReader.h>

namespace assets {

/// bumpmap.png: the skin of a reptile, rounded scales with grooves between them and a fine grain.
///
/// 1024 x 512 texels. The scales are placed on the sphere itself and then mapped to longitude and
/// polar angle, so that they all have the same size and there is no seam. Near the poles the relief
/// fades out.
[[nodiscard]] raytracer::ByteImage makeSkinMap();

}  // namespace assets

#endif
