#ifndef RAYTRACER_APP_PREVIEW_H
#define RAYTRACER_APP_PREVIEW_H

#include "Terminal.h"

#include <raytracer/io/ImageReader.h>

#include <string>

namespace raytracer {

/// Draws pictures in a terminal, each over the previous one. In colour, a cell shows two pixels,
/// one above the other, as an upper half block: foreground colour above, background colour below.
class Preview {
public:
    explicit Preview(const Terminal& terminal) : terminal_(terminal) {}

    /// True if a changing picture can be redrawn in place.
    [[nodiscard]] bool redraws() const { return terminal_.redraws; }

    /// The text that draws the picture on the lines above the cursor. It leaves one column and two
    /// lines of the terminal free, and never enlarges the picture.
    [[nodiscard]] std::string frame(const ByteImage& picture);

private:
    Terminal terminal_;
    int linesDrawn_ = 0;
};

}  // namespace raytracer

#endif
