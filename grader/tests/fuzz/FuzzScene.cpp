// Scene files, including students' own.
#include "../support/Files.h"
#include "../support/TemporaryFolder.h"
#include "Fuzz.h"

#include <raytracer/base/Error.h>
#include <raytracer/io/SceneReader.h>

#include <cmath>

namespace ticker::fuzz {
namespace {

bool isFinite(const raytracer::Vector3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check(const raytracer::SceneDescription& scene) {
    require(!scene.spheres.empty() || !scene.planes.empty(), "there is an object");
    for (const raytracer::SphereDescription& sphere : scene.spheres)
        require(isFinite(sphere.centre) && sphere.radius > 0.0 && std::isfinite(sphere.radius),
                "a sphere is one");
    for (const raytracer::PlaneDescription& plane : scene.planes)
        require(isFinite(plane.point) && plane.normal.magnitude() > 0.0, "a plane has a normal");
}

}  // namespace

bool give(std::string_view input) {
    static const tests::TemporaryFolder folder;
    folder.write("scene.xml", input);
    try {
        check(raytracer::readScene(folder.path() / "scene.xml", TICKER_SOURCE_DIR "/assets"));
        return true;
    } catch (const raytracer::InputError&) {
        return false;
    }
}

std::vector<std::string> seeds() {
    std::vector<std::string> texts;
    for (const char* name : {"distributed", "penumbra", "lens-grid", "bump-mapping"})
        texts.push_back(tests::readFile(std::string{"scenes/"} + name + ".xml"));
    return texts;
}

}  // namespace ticker::fuzz
