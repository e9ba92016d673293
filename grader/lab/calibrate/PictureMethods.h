#ifndef TICKER_CALIBRATE_PICTUREMETHODS_H
#define TICKER_CALIBRATE_PICTUREMETHODS_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/scene/SceneDescription.h>

#include <cstdint>
#include <vector>

namespace ticker::calibrate {

/// What other ways of judging say of one picture, each against whichever accepted reading suits it
/// best.
struct PictureScores {
    double rmse = 0.0;  ///< of bytes, tone mapped
    double ssim = 0.0;  ///< likewise
    double flip = 0.0;  ///< likewise, mean
    /// Share of pixels' channels that Mitsuba 3's z-test of renders lets pass; it asks for 0.9975.
    double zTest = 0.0;
};

/// The pictures that a scene should give: one for each accepted aperture and shape of the light,
/// without noise, and their variance.
class PictureMethods {
public:
    PictureMethods(const raytracer::SceneDescription& scene,
                   const raytracer::RenderSettings& settings);

    /// @param picture  One render, linear, rows from the top.
    [[nodiscard]] PictureScores score(const std::vector<raytracer::ColourRGB>& picture) const;

private:
    struct Reference {
        std::vector<std::uint8_t> bytes;
        std::vector<raytracer::ColourRGB> mean;
        std::vector<raytracer::ColourRGB> variance;  // of one render
    };
    int width_;
    int height_;
    std::vector<Reference> references_;
};

}  // namespace ticker::calibrate

#endif
