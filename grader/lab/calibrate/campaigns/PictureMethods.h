#ifndef TICKER_CALIBRATE_PICTUREMETHODS_H
#define TICKER_CALIBRATE_PICTUREMETHODS_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/scene/SceneDescription.h>

#include <cstdint>
#include <vector>

namespace ticker::calibrate {

/// Scores of one picture under other ways of judging, each against the accepted reading that fits
/// best.
struct PictureScores {
    double rmse = 0.0;  ///< of bytes, tone mapped
    double ssim = 0.0;  ///< likewise
    double flip = 0.0;  ///< likewise, mean
    /// Share of the pixels' channels that pass the z-test of Mitsuba 3's renders, which requires
    /// 0.9975.
    double zTest = 0.0;
};

/// The expected pictures of a scene: one for each accepted aperture and shape of the light, without
/// noise, and their variance.
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
