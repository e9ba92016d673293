#include <grader/oracle/references/References.h>

#include <grader/oracle/kernel/Kernel.h>
#include <grader/oracle/references/FloatTiff.h>
#include <grader/oracle/references/Manifest.h>
#include <grader/oracle/references/ReferenceRender.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/ImageWriter.h>

#include <cmath>

namespace ticker::oracle {
namespace {

using raytracer::ColourRGB;

// Rounds to 12 significant bits: the other twelve of single precision are noise, which does not
// compress.
double rounded(double value) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return std::ldexp(std::round(fraction * 0x1p12), exponent - 12);
}

FloatPicture varianceOf(const Moments& moments) {
    FloatPicture picture{moments.width, moments.height, {}};
    for (const Covariance& c : moments.covariance)
        picture.pixels.emplace_back(rounded(c.rr), rounded(c.gg), rounded(c.bb));
    return picture;
}

FloatPicture errorPicture(const Moments& moments) {
    FloatPicture picture{moments.width, moments.height, {}};
    for (const ColourRGB& e : moments.meanError)
        picture.pixels.emplace_back(rounded(e.r), rounded(e.g), rounded(e.b));
    return picture;
}

Provenance provenanceOf(const ReferenceScene& scene, const Moments& moments,
                        const ReferenceOptions& options) {
    Provenance p;
    p.sceneHash = sceneHash(scene.scene);
    p.settings = scene.settings;
    p.pinhole = scene.pinhole;
    p.lensPaths = moments.lensPaths;
    p.rmsError = moments.rmsError();
    p.seedHash = numberHash(options.seed);
    p.toolVersion = options.toolVersion;
    p.instructionSet = instructionSet();
    return p;
}

void writeOne(const std::filesystem::path& folder, const std::string& name,
              const Moments& moments) {
    raytracer::writePng(toImage(moments), fileOf(folder, name, ".png"));
    writeTiff({moments.width, moments.height, moments.mean}, fileOf(folder, name, "-mean.tiff"));
    writeTiff(varianceOf(moments), fileOf(folder, name, "-variance.tiff"));
    writeTiff(errorPicture(moments), fileOf(folder, name, "-error.tiff"));
}

}  // namespace

bool writeReferences(const std::filesystem::path& folder, const std::vector<ReferenceScene>& scenes,
                     const ReferenceOptions& options, const ReferenceListener& listener) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw raytracer::InputError(folder.string(), 0, error.message());
    Manifest manifest = readManifest(folder);
    const ReferenceClock progress{scenes, listener};
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        progress.tell(i);
        const Moments moments = momentsOf(scenes[i], options.rms, options.seed + i);
        if (interrupted(scenes[i])) return false;
        writeOne(folder, scenes[i].name, moments);
        manifest[scenes[i].name] = provenanceOf(scenes[i], moments, options);
        writeManifest(manifest, folder);
    }
    progress.tell(scenes.size());
    return true;
}

}  // namespace ticker::oracle
