#ifndef TICKER_PROBE_QUESTION_H
#define TICKER_PROBE_QUESTION_H

#include <raytracer/base/RenderSettings.h>
#include <raytracer/geometry/HeightMap.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/math/Vector3.h>
#include <raytracer/scene/SceneDescription.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ticker::probe {

using raytracer::ColourRGB;
using raytracer::Vector3;

/// Largest width and height of a picture that `Renderer::render` is asked for, in pixels.
inline constexpr int kLargestFrame = 4096;

/// A height map in compact form: height(column, row) is `columns[column] + rows[row]` if `bytes` is
/// empty, else kBumpFactor * bytes[...] / 255.
struct HeightMapDescription {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> bytes;  ///< width * height, rows from the top; or empty
    std::vector<double> columns;      ///< width
    std::vector<double> rows;         ///< height

    [[nodiscard]] raytracer::HeightMap build() const;
};

/// Describes a map by bytes, to which its heights are rounded.
[[nodiscard]] HeightMapDescription describe(const raytracer::HeightMap& map);

/// Asks `BumpySphere::getNormalAt` at points of one sphere. The sphere stands in a scene built like
/// a render's, so that a submission cannot tell it from the sphere of a picture.
struct NormalQuestion {
    Vector3 centre;
    double radius = 1.0;
    raytracer::Material material;
    HeightMapDescription map;
    raytracer::SceneDescription company;  ///< the rest of the scene; the sphere is added last
    std::vector<Vector3> positions;       ///< on the sphere, world space
};

/// A point to be lit: arguments of `Renderer::illuminate`.
struct LitPoint {
    int object = 0;  ///< index in Scene::objects(): spheres first, then planes
    Vector3 position;
    Vector3 normal;
    Vector3 viewer;
};

/// Asks `Renderer::illuminate` at points, one after the other, each after seedRandom(seed + i).
struct IlluminateQuestion {
    raytracer::SceneDescription scene;
    raytracer::RenderSettings settings;
    std::vector<LitPoint> points;
    std::uint32_t eventCapacity = 0;  ///< most logged events; 0: no log
};

/// Asks `Renderer::render`, `repetitions` times with settings.seed, settings.seed + 1, ...
struct RenderQuestion {
    raytracer::SceneDescription scene;
    raytracer::RenderSettings settings;
    int repetitions = 1;
    std::uint32_t eventCapacity = 0;  ///< most logged events of all repetitions; 0: no log
};

/// A ray to be cast. A HitQuestion uses `object` (index as in LitPoint), a TraceQuestion `bounces`.
struct CastRay {
    int object = 0;
    int bounces = 0;
    Vector3 origin;
    Vector3 direction;
};

/// Asks `SceneObject::intersectionWith` of objects of a scene, each with a ray.
struct HitQuestion {
    raytracer::SceneDescription scene;
    std::vector<CastRay> rays;
};

/// Asks `Renderer::trace` along rays, one after the other.
struct TraceQuestion {
    raytracer::SceneDescription scene;
    raytracer::RenderSettings settings;
    std::vector<CastRay> rays;
    std::uint32_t eventCapacity = 0;  ///< most logged events; 0: no log
};

/// Asks a function that the exercise has named (Calls.h), once for each row of arguments, each call
/// after seedRandom(seed + i).
struct CallQuestion {
    std::string function;  ///< name of the `Call`
    raytracer::SceneDescription scene;
    std::uint64_t seed = 0;
    std::uint32_t width = 1;        ///< arguments of each call
    std::vector<double> arguments;  ///< row after row
};

using Question = std::variant<NormalQuestion, IlluminateQuestion, RenderQuestion, HitQuestion,
                              TraceQuestion, CallQuestion>;

/// A hit fills three values: (is a hit, distance, object), location, normal.
inline constexpr std::size_t kValuesOfHit = 3;

/// An event that RenderObserver reported, in order of occurrence on each thread. `ask` is the index
/// of the point or repetition that it belongs to. Fields that an event does not have are zero.
struct Event {
    enum class Kind : std::uint16_t {
        cameraRayAsked,    ///< x, y; a = origin, b = direction
        traceBegan,        ///< bounces; a = origin, b = direction
        traceEnded,        ///< a = colour
        illuminateBegan,   ///< object; a = position, b = normal
        illuminateViewer,  ///< a = viewer; the thread's next event after illuminateBegan
        illuminateEnded,   ///< a = colour
        rayCast,           ///< object hit or -1; distance; a = origin, b = direction
        pixelSet           ///< x, y; a = colour
    };
    Kind kind = Kind::rayCast;
    std::uint16_t thread = 0;  ///< 0 for the thread with the first event, then 1, ..., modulo 2^16
    std::uint32_t ask = 0;
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t object = -1;  ///< index in Scene::objects()
    std::int32_t bounces = 0;
    double distance = 0.0;
    Vector3 a;
    Vector3 b;
};

/// How an answer ended. Every field of an answer comes from the student's process: untrusted.
enum class AnswerState : std::uint32_t {
    missing = 0,  ///< never reached: the process ended before
    answered = 1,
    threw = 2  ///< the student's code threw an exception; its text is `message`
};

/// Unanswered parts of an answer hold NaN in every component; `isUnanswered` (AnswerMemory.h)
/// distinguishes them from computed NaNs.
struct NormalAnswer {
    AnswerState state = AnswerState::missing;
    std::string message;           ///< of the first exception; untrusted text
    std::uint32_t exceptions = 0;  ///< number of positions at which an exception was thrown
    std::vector<Vector3> normals;  ///< one for each position
};

/// The answer to an IlluminateQuestion or a TraceQuestion.
struct IlluminateAnswer {
    AnswerState state = AnswerState::missing;
    std::string message;
    std::vector<ColourRGB> colours;  ///< one for each point or ray
    std::vector<Event> events;
    bool eventsCut = false;        ///< more events occurred than fit
    std::uint32_t exceptions = 0;  ///< number of points at which an exception was thrown
};

/// What an object returns for a ray.
struct Hit {
    bool isHit = false;
    double distance = 0.0;
    int object = -1;  ///< the one that the hit names, index in Scene::objects()
    Vector3 location;
    Vector3 normal;
};

struct HitAnswer {
    AnswerState state = AnswerState::missing;
    std::string message;
    std::uint32_t exceptions = 0;  ///< number of rays at which an exception was thrown
    std::vector<Hit> hits;         ///< one for each ray
};

struct CallAnswer {
    AnswerState state = AnswerState::missing;
    std::string message;
    std::uint32_t exceptions = 0;  ///< number of calls in which an exception was thrown
    std::vector<Vector3> values;   ///< one for each row of arguments
};

struct RenderAnswer {
    AnswerState state = AnswerState::missing;
    std::string message;
    int width = 0;  ///< as asked; a wrong size is `wrongSize`
    int height = 0;
    bool wrongSize = false;                      ///< the image has another size
    std::vector<std::vector<ColourRGB>> images;  ///< one for each repetition, rows from the top
    std::vector<Event> events;
    bool eventsCut = false;
    std::uint32_t exceptions = 0;  ///< number of repetitions in which an exception was thrown
};

using Answer = std::variant<NormalAnswer, IlluminateAnswer, RenderAnswer, HitAnswer, CallAnswer>;

}  // namespace ticker::probe

#endif
