#include <grader/oracle/FloatTiff.h>

#include <raytracer/base/Error.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <fstream>
#include <string>

namespace ticker::oracle {

using raytracer::InputError;

void replaceWhole(const std::filesystem::path& file, const std::string& bytes) {
    const std::filesystem::path partial = file.string() + ".partial";
    {
        std::ofstream stream{partial, std::ios::binary};
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        stream.close();
        if (!stream) throw InputError(file.string(), 0, "cannot be written");
    }
    std::error_code error;
    std::filesystem::rename(partial, file, error);
    if (error) throw InputError(file.string(), 0, "cannot be replaced: " + error.message());
}

void writeTiff(const FloatPicture& picture, const std::filesystem::path& file) {
    constexpr int kDeflate = 8;  // "Adobe deflate" of the TIFF standard
    // No braces: they would make a list of three numbers.
    cv::Mat matrix(picture.height, picture.width, CV_32FC3);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const raytracer::ColourRGB& c =
                picture.pixels[static_cast<std::size_t>(y * picture.width + x)];
            matrix.at<cv::Vec3f>(y, x) = {static_cast<float>(c.b), static_cast<float>(c.g),
                                          static_cast<float>(c.r)};
        }
    }
    std::vector<unsigned char> bytes;
    bool packed = false;
    try {
        packed = cv::imencode(".tiff", matrix, bytes, {cv::IMWRITE_TIFF_COMPRESSION, kDeflate});
    } catch (const cv::Exception&) {
        packed = false;
    }
    if (!packed) throw InputError(file.string(), 0, "the picture cannot be packed as TIFF");
    replaceWhole(file, std::string(bytes.begin(), bytes.end()));
}

FloatPicture readTiff(const std::filesystem::path& file) {
    cv::Mat matrix;
    try {
        matrix = cv::imread(file.string(), cv::IMREAD_UNCHANGED);
    } catch (const cv::Exception&) {
        matrix.release();
    }
    if (matrix.empty()) throw InputError(file.string(), 0, "no TIFF picture that can be read");
    if (matrix.type() != CV_32FC3)
        throw InputError(file.string(), 0, "expected three 32-bit floats for each pixel");
    FloatPicture picture{matrix.cols, matrix.rows, {}};
    for (int y = 0; y < matrix.rows; ++y) {
        for (int x = 0; x < matrix.cols; ++x) {
            const cv::Vec3f& c = matrix.at<cv::Vec3f>(y, x);
            picture.pixels.emplace_back(double{c[2]}, double{c[1]}, double{c[0]});
        }
    }
    return picture;
}

}  // namespace ticker::oracle
