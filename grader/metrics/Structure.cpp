#include <grader/metrics/Structure.h>

#include <opencv2/core.hpp>
#include <opencv2/quality/qualitygmsd.hpp>
#include <opencv2/quality/qualityssim.hpp>

namespace ticker::metrics {
namespace {

/// OpenCV takes non-const data, but only reads it.
cv::Mat matOf(const ByteView& picture) {
    return {picture.height, picture.width, CV_8UC3, const_cast<std::uint8_t*>(picture.rgb.data())};
}

double meanOfChannels(const cv::Scalar& channels) {
    return (channels[0] + channels[1] + channels[2]) / 3.0;
}

Map mapOf(const cv::UMat& quality) {
    cv::Mat channels;
    quality.copyTo(channels);
    Map map{channels.cols, channels.rows, {}};
    map.values.reserve(channels.total());
    for (int y = 0; y < channels.rows; ++y)
        for (int x = 0; x < channels.cols; ++x) {
            const auto& pixel = channels.at<cv::Vec3f>(y, x);
            map.values.push_back((pixel[0] + pixel[1] + pixel[2]) / 3.0F);
        }
    return map;
}

}  // namespace

Measured ssim(const ByteView& reference, const ByteView& test) {
    requireSameSize(reference, test);
    cv::UMat quality;
    const cv::Scalar channels =
        cv::quality::QualitySSIM::compute(matOf(reference), matOf(test), quality);
    return {meanOfChannels(channels), mapOf(quality)};
}

Measured gmsd(const ByteView& reference, const ByteView& test) {
    requireSameSize(reference, test);
    cv::UMat quality;
    const cv::Scalar channels =
        cv::quality::QualityGMSD::compute(matOf(reference), matOf(test), quality);
    return {meanOfChannels(channels), mapOf(quality)};
}

}  // namespace ticker::metrics
