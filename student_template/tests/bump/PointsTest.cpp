// What every point of the sphere must give: a normal, of unit length, that points outwards.
#include <bump/BumpMapping.h>
#include <questions/BumpQuestions.h>
#include <raytracer/geometry/BumpySphere.h>
#include <support/Complaint.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace raytracer::tests::bump {
namespace {

/// The likely cause of an error of HeightMap::at.
std::string causeOf(const std::string& error) {
    if (error.find("column -") != std::string::npos || error.find("row -") != std::string::npos)
        return "u and v go from 0 to 1: take the position relative to centre(), divide by "
               "radius(), "
               "and shift a longitude that may be negative. The acos of more than 1 is no number, "
               "and becomes the most negative row";
    return "columns go from 0 to width() - 1 and rows from 0 to height() - 1; the neighbour of the "
           "last one needs care";
}

TEST_F(BumpMapping, EveryPointOfAMapOfAnySizeHasANormal) {
    const Vector3 centre{0.4, -0.2, 3.5};
    for (const auto& [width, height] : {std::pair{4, 4}, {7, 5}, {97, 41}, {41, 97}}) {
        const std::string map =
            "a map of " + std::to_string(width) + " x " + std::to_string(height) + " texels";
        const BumpySphere& sphere = keptSphere(centre, 0.7, roughMap(width, height));
        for (const Vector3& direction : telltaleDirections()) {
            const std::string asked =
                "the point " + words(direction) + " * radius + centre, " + map;
            try {
                const Vector3 normal = sphere.getNormalAt(centre + direction * 0.7);
                if (std::isfinite(normal.x + normal.y + normal.z)) continue;
                complain(asked, "a normal of numbers", words(normal),
                         "a division by zero, or acos of something beyond 1: rounding makes that "
                         "happen at a pole or straight ahead",
                         "Option 1: What to do, step 1");
            } catch (const std::exception& error) {
                const std::string what = error.what();
                complain(asked, "a normal", "the error: " + what, causeOf(what),
                         "Option 1: What to do, steps 1 and 3");
            }
            return;
        }
    }
}

TEST_F(BumpMapping, NormalsHaveUnitLength) {
    const BumpySphere& sphere = keptSphere({0.4, -0.2, 3.5}, 0.7, roughMap(97, 41));
    for (const Vector3& direction : telltaleDirections()) {
        Vector3 normal;
        try {
            normal = sphere.getNormalAt(sphere.centre() + direction * 0.7);
        } catch (const std::exception&) {
            continue;
        }
        const double length = normal.magnitude();
        if (std::abs(length - 1.0) < 1e-4 || !std::isfinite(length)) continue;
        complain("the point " + words(direction) + " * radius + centre", "length 1",
                 "length " + inWords(length), "normalise the sum at the end",
                 "Option 1: What to do, step 4");
        return;
    }
}

TEST_F(BumpMapping, NormalsPointOutwards) {
    if (!couldSurvey()) return;
    const BumpySphere& sphere = keptSphere(
        {1.3, -0.7, 25.0}, 14.0, mapOf(questions::ramp(1500, kGentle.rise), questions::level(90)));
    const std::vector<Vector3> directions = telltaleDirections();
    const auto inward =
        std::count_if(directions.begin(), directions.end(), [&](const Vector3& direction) {
            return sphere.getNormalAt(sphere.centre() + direction * 14.0).dot(direction) <= 0.0;
        });
    if (inward * 50 <= std::ssize(directions)) return;
    complain("a nearly flat map", "normals that point away from the centre",
             std::to_string(inward) + " of " + std::to_string(directions.size()) +
                 " point to the other side",
             "the smooth normal leads from the centre to the point, not back; it is the largest "
             "part of the sum",
             "Option 1: What to do, steps 1 and 4");
}

}  // namespace
}  // namespace raytracer::tests::bump
