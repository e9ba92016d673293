#include <grader/tasks/lens/questions/PictureQuestions.h>
#include <grader/tasks/support/Draw.h>

namespace ticker::tasks {
namespace {

// Eight pictures of 24 x 18 pixels, or one picture with about as many pixels in all.
constexpr int kPictureWidth = 24;
constexpr int kPictureRepetitions = 8;
constexpr int kLargeWidth = 68;
// The same scene in smaller pixels, with fewer repetitions.
constexpr int kFineWidth = static_cast<int>(kPictureWidth * kFinerPixels);
constexpr int kFineRepetitions = 4;

void addSphere(raytracer::SceneDescription& scene, Draw& draw, const Vector3& centre,
               double radius) {
    raytracer::Material material;
    material.colour = draw.colour(0.05, 1.0);
    material.reflectivity = draw.between(0.1, 0.4);
    scene.spheres.push_back({centre, radius, material, nullptr});
}

// A wall that faces the eye.
raytracer::PlaneDescription wallAt(double z, Draw& draw) {
    raytracer::Material material;
    material.colour = draw.colour(0.2, 0.8);
    return {{0.0, 0.0, z}, {0.0, 0.0, z > 0.0 ? -1.0 : 1.0}, material};
}

// Adds objects that only mirrored rays meet. A student's own recursion shows its mistakes in them.
void addBehindTheEye(raytracer::SceneDescription& scene, Draw& draw) {
    for (int i = 0; i < 8; ++i) {
        const double z = draw.between(-6.0, -2.5);
        const double x = draw.between(-0.8, 0.8) * z;
        const double radius = draw.between(-0.3, -0.15) * z;
        addSphere(scene, draw, {x, draw.between(-0.8, 0.8) * z, z}, radius);
    }
    scene.planes.push_back(wallAt(-8.0, draw));
}

}  // namespace

probe::RenderQuestion drawPictureQuestion(std::uint64_t seed, bool onePicture) {
    Draw draw{seed, 23};
    probe::RenderQuestion question;
    question.settings.width = onePicture ? kLargeWidth : kPictureWidth;
    question.settings.height = question.settings.width * 3 / 4;
    question.settings.seed = draw.word() >> 1U;
    question.repetitions = onePicture ? 1 : kPictureRepetitions;
    question.scene.ambientLighting = ColourRGB{1.0};
    for (int i = 0; i < 40; ++i) {
        const double z = draw.between(1.8, 9.0);
        const double x = draw.between(-0.42, 0.42) * z;
        const double radius = draw.between(0.02, 0.06) * z;
        addSphere(question.scene, draw, {x, draw.between(-0.32, 0.32) * z, z}, radius);
    }
    question.scene.planes.push_back(wallAt(12.0, draw));
    addBehindTheEye(question.scene, draw);
    return question;
}

probe::RenderQuestion drawFinePictureQuestion(std::uint64_t seed) {
    probe::RenderQuestion question = drawPictureQuestion(seed);
    question.settings.width = kFineWidth;
    question.settings.height = kFineWidth * 3 / 4;
    question.repetitions = kFineRepetitions;
    return question;
}

}  // namespace ticker::tasks
