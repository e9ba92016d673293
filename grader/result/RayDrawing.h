#ifndef TICKER_RESULT_RAYDRAWING_H
#define TICKER_RESULT_RAYDRAWING_H

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ticker {

/// Observed rays of one pixel or point, or normals of a sphere, to be drawn in 3-D. The page's
/// script draws the same format as the students' viewer
/// (student_template/framework/app/view/page/drawing.js).
struct RayDrawing {
    using Point = std::array<double, 3>;  ///< world space: x, y, z

    struct Ball {
        std::string name;
        Point centre{};
        double radius = 0.0;
    };
    struct Sheet {
        std::string name;
        Point point{};
        Point normal{};
    };
    enum class Kind { camera, arrives, blocked, expected };
    struct Ray {
        Kind kind = Kind::camera;
        Point from{};
        Point to{};
        std::string words;
        int light = -1;  ///< index of the light that a shadow ray aims at
    };

    struct Normal {
        Point at{};
        Point smooth{};  ///< of the sphere; directions have unit length
        std::optional<Point> expected = {};
        Point given{};
    };

    std::string about;  ///< one line
    std::vector<std::string> words;
    std::vector<Ball> spheres;
    std::vector<Sheet> planes;
    std::vector<Ball> lights;
    double lensHalfWidth = -1.0;  ///< negative: no lens is drawn
    double focalPlane = 0.0;      ///< its z; 0: not drawn
    std::vector<Ray> rays;
    std::vector<Normal> normals;
    std::vector<std::vector<Point>> outlines;  ///< lines on a surface, each from point to point
};

}  // namespace ticker

#endif
