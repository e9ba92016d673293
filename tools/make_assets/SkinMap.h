#ifndef TOOLS_MAKE_ASSETS_SKINMAP_H
#define TOOLS_MAKE_ASSETS_SKINMAP_H

#include <raytracer/io/ImageReader.h>

namespace assets {

/// bumpmap.png: the skin of a reptile, rounded scales with grooves between them and a fine grain.
///
/// 1024 x 512 texels. The scales are laid out on the sphere itself and then written down by
/// longitude and polar angle, so that they have the same size everywhere and no seam. Near the
/// poles the relief fades away.
[[nodiscard]] raytracer::ByteImage makeSkinMap();

}  // namespace assets

#endif
