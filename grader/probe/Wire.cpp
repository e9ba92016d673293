#include <grader/probe/Wire.h>

#include <grader/probe/ByteStream.h>
#include <grader/probe/SceneWire.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <type_traits>

namespace ticker::probe {
namespace {

using raytracer::Material;
using raytracer::RenderSettings;
using raytracer::SceneDescription;

constexpr std::uint32_t kMagic = 0x544B5051;  // "TKPQ"
constexpr std::uint32_t kVersion = 5;
constexpr int kMostRepetitions = 4096;

void check(const RenderSettings& settings) {
    const bool fits = settings.width > 0 && settings.height > 0 &&
                      settings.width <= kLargestFrame && settings.height <= kLargestFrame &&
                      settings.imageWidth() <= kLargestFrame &&
                      settings.imageHeight() <= kLargestFrame;
    if (!fits) refuse("an image's size must be 1 to 4096 pixels");
}

void check(const NormalQuestion& question) {
    if (question.map.width > kLargestMapSide || question.map.height > kLargestMapSide)
        refuse("a map is too large");
    const std::uint64_t texels = static_cast<std::uint64_t>(std::max(0, question.map.width)) *
                                 static_cast<std::uint64_t>(std::max(0, question.map.height));
    const bool fits =
        question.map.bytes.empty()
            ? question.map.columns.size() * question.map.rows.size() == texels &&
                  question.map.columns.size() == static_cast<std::uint64_t>(question.map.width)
            : question.map.bytes.size() == texels;
    if (!fits) refuse("a map has another number of heights than its size says");
}

/// @param asked  Points or rays.
template <class Asked>
void checkObjects(const std::vector<Asked>& asked, const SceneDescription& scene) {
    const std::size_t objects = scene.spheres.size() + scene.planes.size();
    const bool allThere = std::ranges::all_of(asked, [&](const Asked& one) {
        return one.object >= 0 && static_cast<std::size_t>(one.object) < objects;
    });
    if (!allThere) refuse("a point lies on an object that is not in the scene");
}

void check(const IlluminateQuestion& question) {
    check(question.settings);
    checkObjects(question.points, question.scene);
}

void check(const HitQuestion& question) {
    checkObjects(question.rays, question.scene);
}

void check(const TraceQuestion& question) {
    check(question.settings);
}

void check(const CallQuestion& question) {
    if (question.width == 0 || question.arguments.size() % question.width != 0)
        refuse("the arguments of a call are no whole rows");
}

void check(const RenderQuestion& question) {
    check(question.settings);
    if (question.repetitions < 1 || question.repetitions > kMostRepetitions)
        refuse("repetitions must be 1 to 4096");
}

/// Settings are written field by field: padding bytes of a struct are indeterminate, and equal
/// questions must give equal messages.
template <class Settings, class Each>
void eachField(Settings& settings, const Each& each) {
    each(settings.width);
    each(settings.height);
    each(settings.bounces);
    each(settings.shadowRayCount);
    each(settings.lightSize);
    each(settings.dofRayCount);
    each(settings.dofFocalPlane);
    each(settings.dofAmount);
    each(settings.region);
    each(settings.seed);
    each(settings.threads);
}

void putSettings(ByteWriter& writer, const RenderSettings& settings) {
    eachField(settings, [&](const auto& field) { writer.put(field); });
}

RenderSettings getSettings(ByteReader& reader) {
    RenderSettings settings;
    eachField(settings,
              [&](auto& field) { field = reader.get<std::remove_cvref_t<decltype(field)>>(); });
    return settings;
}

void putPoints(ByteWriter& writer, const std::vector<LitPoint>& points) {
    writer.put(static_cast<std::uint64_t>(points.size()));
    for (const LitPoint& point : points) {
        writer.put(point.object);
        writer.put(point.position);
        writer.put(point.normal);
        writer.put(point.viewer);
    }
}

std::vector<LitPoint> getPoints(ByteReader& reader) {
    std::vector<LitPoint> points(reader.getCount(sizeof(int) + 3 * sizeof(Vector3)));
    for (LitPoint& point : points) {
        point.object = reader.get<int>();
        point.position = reader.get<Vector3>();
        point.normal = reader.get<Vector3>();
        point.viewer = reader.get<Vector3>();
    }
    return points;
}

struct Put {
    ByteWriter& writer;

    void operator()(const NormalQuestion& question) const {
        check(question);
        writer.put(question.centre);
        writer.put(question.radius);
        writer.put(question.material);
        putScene(writer, question.company);
        writer.put(question.map.width);
        writer.put(question.map.height);
        writer.putAll(question.map.bytes);
        writer.putAll(question.map.columns);
        writer.putAll(question.map.rows);
        writer.putAll(question.positions);
    }
    void operator()(const IlluminateQuestion& question) const {
        check(question);
        putScene(writer, question.scene);
        putSettings(writer, question.settings);
        putPoints(writer, question.points);
        writer.put(question.eventCapacity);
    }
    void operator()(const RenderQuestion& question) const {
        check(question);
        putScene(writer, question.scene);
        putSettings(writer, question.settings);
        writer.put(question.repetitions);
        writer.put(question.eventCapacity);
    }
    void operator()(const HitQuestion& question) const {
        check(question);
        putScene(writer, question.scene);
        writer.putAll(question.rays);
    }
    void operator()(const TraceQuestion& question) const {
        check(question);
        putScene(writer, question.scene);
        putSettings(writer, question.settings);
        writer.putAll(question.rays);
        writer.put(question.eventCapacity);
    }
    void operator()(const CallQuestion& question) const {
        check(question);
        writer.putAll(std::vector<char>{question.function.begin(), question.function.end()});
        putScene(writer, question.scene);
        writer.put(question.seed);
        writer.put(question.width);
        writer.putAll(question.arguments);
    }
};

NormalQuestion getNormalQuestion(ByteReader& reader) {
    NormalQuestion question;
    question.centre = reader.get<Vector3>();
    question.radius = reader.get<double>();
    question.material = reader.get<Material>();
    question.company = getScene(reader);
    question.map.width = reader.get<int>();
    question.map.height = reader.get<int>();
    question.map.bytes = reader.getAll<std::uint8_t>();
    question.map.columns = reader.getAll<double>();
    question.map.rows = reader.getAll<double>();
    question.positions = reader.getAll<Vector3>();
    check(question);
    return question;
}

IlluminateQuestion getIlluminateQuestion(ByteReader& reader) {
    IlluminateQuestion question;
    question.scene = getScene(reader);
    question.settings = getSettings(reader);
    question.points = getPoints(reader);
    question.eventCapacity = reader.get<std::uint32_t>();
    check(question);
    return question;
}

RenderQuestion getRenderQuestion(ByteReader& reader) {
    RenderQuestion question;
    question.scene = getScene(reader);
    question.settings = getSettings(reader);
    question.repetitions = reader.get<int>();
    question.eventCapacity = reader.get<std::uint32_t>();
    check(question);
    return question;
}

HitQuestion getHitQuestion(ByteReader& reader) {
    HitQuestion question;
    question.scene = getScene(reader);
    question.rays = reader.getAll<CastRay>();
    check(question);
    return question;
}

TraceQuestion getTraceQuestion(ByteReader& reader) {
    TraceQuestion question;
    question.scene = getScene(reader);
    question.settings = getSettings(reader);
    question.rays = reader.getAll<CastRay>();
    question.eventCapacity = reader.get<std::uint32_t>();
    check(question);
    return question;
}

CallQuestion getCallQuestion(ByteReader& reader) {
    CallQuestion question;
    const auto name = reader.getAll<char>();
    question.function.assign(name.begin(), name.end());
    question.scene = getScene(reader);
    question.seed = reader.get<std::uint64_t>();
    question.width = reader.get<std::uint32_t>();
    question.arguments = reader.getAll<double>();
    check(question);
    return question;
}

Question getQuestion(ByteReader& reader) {
    switch (reader.get<std::uint32_t>()) {
        case 0:
            return getNormalQuestion(reader);
        case 1:
            return getIlluminateQuestion(reader);
        case 2:
            return getRenderQuestion(reader);
        case 3:
            return getHitQuestion(reader);
        case 4:
            return getTraceQuestion(reader);
        case 5:
            return getCallQuestion(reader);
        default:
            refuse("a question of no known kind");
    }
}

}  // namespace

std::vector<std::byte> encodeQuestions(const std::vector<Question>& questions) {
    ByteWriter writer;
    writer.put(kMagic);
    writer.put(kVersion);
    writer.put(static_cast<std::uint64_t>(questions.size()));
    for (const Question& question : questions) {
        writer.put(static_cast<std::uint32_t>(question.index()));
        std::visit(Put{writer}, question);
    }
    return writer.take();
}

std::vector<Question> decodeQuestions(std::span<const std::byte> message) {
    ByteReader reader{message};
    if (reader.get<std::uint32_t>() != kMagic || reader.get<std::uint32_t>() != kVersion)
        refuse("not a message of this version");
    const std::size_t count = reader.getCount(sizeof(std::uint32_t));
    std::vector<Question> questions;
    for (std::size_t i = 0; i < count; ++i)
        questions.push_back(getQuestion(reader));
    if (!reader.atEnd()) refuse("bytes are left over");
    return questions;
}

}  // namespace ticker::probe
