#include <grader/pipeline/DrawRasters.h>

#include <grader/metrics/Colours.h>
#include <grader/picture/EncodePicture.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace ticker::pipeline {
namespace {

std::string pngOf(const Raster& raster) {
    raytracer::ByteImage image{raster.width, raster.height, {}};
    if (raster.colours == Raster::Colours::diverging) {
        image.rgb = metrics::blueWhiteRed({raster.width, raster.height, raster.values}, 1.0);
    } else {
        for (const float value : raster.values)
            // Written so that NaN becomes black.
            image.rgb.insert(
                image.rgb.end(), 3,
                static_cast<std::uint8_t>(value > 0.0F ? std::min(value, 1.0F) * 255.0F : 0.0F));
    }
    return picture::encodePicture(image);
}

}  // namespace

void drawRasters(SubmissionResult& result) {
    for (TaskReport& task : result.tasks) {
        int count = 0;
        const auto draw = [&](std::vector<Raster>& rasters) {
            for (Raster& raster : rasters) {
                raster.image = fmt::format("images/{}-{}.png", task.id, ++count);
                result.pictures.push_back({raster.image, raster.title, pngOf(raster)});
            }
        };
        for (Finding& finding : task.findings)
            draw(finding.rasters);
        draw(task.rasters);
    }
}

}  // namespace ticker::pipeline
