#ifndef RAYTRACER_APP_PREVIEW_H
#define RAYTRACER_APP_PREVIEW_H

#include "Terminal.h"

#include <raytracer/io/ImageReader.h>

#include <string>

namespace raytracer {

/// Draws pictures in a terminal, each over the one before. Where there is colour a cell shows two
/// pixels, one above the other, as the upper half block: its letter's colour and its background.
class Preview {
public:
    explicit Preview(const Terminal& terminal) : terminal_(terminal) {}

    /// True where a picture that changes can be drawn over and over.
    [[nodiscard]] bool redraws() const { return terminal_.redraws; }

    /// What to write so that the picture stands on the lines above the cursor. Leaves one column
    /// and two lines of the terminal free; never larger than the picture.
    [[nodiscard]] std::string frame(const ByteImage& picture);

private:
    Terminal terminal_;
    int linesDrawn_ = 0;
};

}  // namespace raytracer

#endif
