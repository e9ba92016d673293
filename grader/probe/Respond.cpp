#include <grader/probe/Respond.h>

#include <grader/probe/AnswerMemory.h>
#include <grader/probe/Calls.h>
#include <grader/probe/EventLog.h>

#include <raytracer/base/Error.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <raytracer/scene/Scene.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace ticker::probe {
namespace {

/// Writes one answer into its place in the answer memory.
class AnswerSheet {
public:
    AnswerSheet(std::span<std::byte> memory, const AnswerPlace& place)
        : memory_(memory),
          place_(place),
          header_(*new (memory.data() + place.header) AnswerHeader{}) {
        header_.state = AnswerHeader::kBegun;
    }

    ~AnswerSheet() {
        const auto state = header_.exceptions > 0 ? AnswerState::threw : AnswerState::answered;
        header_.state = static_cast<std::uint32_t>(state);
    }
    AnswerSheet(const AnswerSheet&) = delete;
    AnswerSheet& operator=(const AnswerSheet&) = delete;

    /// Value `index` of the answer; both Vector3 and ColourRGB are three doubles.
    template <typename Value>
    void write(std::size_t index, const Value& value) {
        std::memcpy(memory_.data() + place_.values + index * sizeof value, &value, sizeof value);
    }

    void sayWrongSize() { header_.wrongSize = 1; }

    /// Runs `work`, which may throw anything.
    template <typename Work>
    void attempt(Work&& work) {
        try {
            std::forward<Work>(work)();
        } catch (const std::exception& error) {
            note(error.what());
        } catch (...) {
            note("an exception that is no std::exception");
        }
    }

    /// A log for this answer's events. It exists even if no events are wanted, and keeps none then:
    /// settings().observer must not reveal whether the rays are logged.
    [[nodiscard]] std::unique_ptr<EventLog> makeLog() {
        if (place_.eventCapacity == 0)
            return std::make_unique<EventLog>(std::span<std::byte>{}, unwanted_);
        return std::make_unique<EventLog>(
            memory_.subspan(place_.events, place_.eventCapacity * sizeof(Event)),
            header_.eventsSeen);
    }

private:
    void note(std::string_view message) {
        if (header_.exceptions++ > 0) return;
        const std::size_t size = std::min(message.size(), sizeof header_.message - 1);
        std::memcpy(header_.message, message.data(), size);
    }

    std::span<std::byte> memory_;
    const AnswerPlace& place_;
    AnswerHeader& header_;
    std::uint64_t unwanted_ = 0;
};

raytracer::SceneDescription withSphere(const NormalQuestion& question,
                                       std::shared_ptr<const raytracer::HeightMap> map) {
    raytracer::SceneDescription scene = question.company;
    scene.spheres.push_back({question.centre, question.radius, question.material, std::move(map)});
    return scene;
}

/// A question's sphere in a scene of its own, built like a render's scene. Of its map the heights
/// are freed once it was asked.
class Stand {
public:
    explicit Stand(const NormalQuestion& question)
        : map_(std::make_shared<raytracer::HeightMap>(question.map.build())),
          scene_(withSphere(question, map_)),
          sphere_(question.company.spheres.size()) {}

    [[nodiscard]] const raytracer::SceneObject& sphere() const {
        return *scene_.objects()[sphere_];
    }
    void freeHeights() {
        constexpr int kSide = raytracer::HeightMap::kSmallestSide;
        *map_ = {kSide, kSide, std::vector<double>(std::size_t{kSide} * kSide)};
    }

private:
    std::shared_ptr<raytracer::HeightMap> map_;
    raytracer::Scene scene_;
    std::size_t sphere_;
};

/// A scene with its observer.
struct Stage {
    std::unique_ptr<EventLog> log;
    raytracer::RenderSettings settings;
    raytracer::Scene scene;

    Stage(AnswerSheet& sheet, const raytracer::SceneDescription& description,
          const raytracer::RenderSettings& wanted)
        : log(sheet.makeLog()), settings(wanted), scene(description, log.get()) {
        settings.observer = log.get();
        log->watch(&scene);
        if (settings.threads > 1) log->takeTurns();
    }

    void begin(std::size_t ask) const { log->beginAsk(static_cast<std::uint32_t>(ask)); }
};

/// The scenes of a run. They stay alive, so that addresses are never reused, as in the program,
/// which has one scene: what a submission keeps for a scene, an object or a map stays valid.
struct Scenes {
    std::deque<Stand> stands;
    std::deque<Stage> stages;
    std::deque<raytracer::Scene> others;
};

const Call& callNamed(std::string_view name) {
    const auto all = calls();
    const auto found = std::ranges::find(all, name, &Call::name);
    if (found == all.end())
        throw raytracer::Error("Calls.cpp of the exercise has no call " + std::string{name});
    return *found;
}

struct Reply {
    AnswerSheet& sheet;
    Scenes& scenes;

    void operator()(const NormalQuestion& question) const {
        Stand& stand = scenes.stands.emplace_back(question);
        for (std::size_t i = 0; i < question.positions.size(); ++i) {
            raytracer::seedRandom(i);
            sheet.attempt(
                [&] { sheet.write(i, stand.sphere().getNormalAt(question.positions[i])); });
        }
        stand.freeHeights();
    }

    void operator()(const IlluminateQuestion& question) const {
        const Stage& stage = scenes.stages.emplace_back(sheet, question.scene, question.settings);
        const raytracer::Renderer renderer{stage.settings};
        for (std::size_t i = 0; i < question.points.size(); ++i) {
            const LitPoint& point = question.points[i];
            const auto& object = *stage.scene.objects()[static_cast<std::size_t>(point.object)];
            stage.begin(i);
            raytracer::seedRandom(question.settings.seed + i);
            sheet.attempt([&] {
                sheet.write(i, renderer.illuminate(stage.scene, object, point.position,
                                                   point.normal, point.viewer));
            });
        }
        stage.log->close();
    }

    void operator()(const RenderQuestion& question) const {
        const Stage& stage = scenes.stages.emplace_back(sheet, question.scene, question.settings);
        for (std::size_t i = 0; i < static_cast<std::size_t>(question.repetitions); ++i) {
            raytracer::RenderSettings settings = stage.settings;
            settings.seed += i;
            stage.begin(i);
            raytracer::seedRandom(settings.seed);
            sheet.attempt([&] {
                copyPixels(i, settings, raytracer::Renderer{settings}.render(stage.scene));
            });
        }
        stage.log->close();
    }

    void operator()(const HitQuestion& question) const {
        const raytracer::Scene& scene = scenes.others.emplace_back(question.scene);
        for (std::size_t i = 0; i < question.rays.size(); ++i) {
            const CastRay& asked = question.rays[i];
            const auto& object = *scene.objects()[static_cast<std::size_t>(asked.object)];
            sheet.attempt([&] {
                writeHit(i, scene, object.intersectionWith({asked.origin, asked.direction}));
            });
        }
    }

    void operator()(const TraceQuestion& question) const {
        const Stage& stage = scenes.stages.emplace_back(sheet, question.scene, question.settings);
        const raytracer::Renderer renderer{stage.settings};
        for (std::size_t i = 0; i < question.rays.size(); ++i) {
            const CastRay& ray = question.rays[i];
            stage.begin(i);
            raytracer::seedRandom(question.settings.seed + i);
            sheet.attempt([&] {
                sheet.write(i,
                            renderer.trace(stage.scene, {ray.origin, ray.direction}, ray.bounces));
            });
        }
        stage.log->close();
    }

    void operator()(const CallQuestion& question) const {
        const Call& call = callNamed(question.function);
        const raytracer::Scene& scene = scenes.others.emplace_back(question.scene);
        const std::span<const double> arguments{question.arguments};
        for (std::size_t i = 0; i < arguments.size() / question.width; ++i) {
            raytracer::seedRandom(question.seed + i);
            const auto row = arguments.subspan(i * question.width, question.width);
            sheet.attempt([&] { sheet.write(i, call.function(scene, row)); });
        }
    }

private:
    void writeHit(std::size_t index, const raytracer::Scene& scene,
                  const std::optional<raytracer::RaycastHit>& hit) const {
        const raytracer::RaycastHit told = hit.value_or(raytracer::RaycastHit{});
        const auto& objects = scene.objects();
        const auto named = std::ranges::find_if(
            objects, [&](const auto& object) { return object.get() == told.object; });
        const auto number = static_cast<double>(named - objects.begin());
        sheet.write(kValuesOfHit * index, Vector3{hit ? 1.0 : 0.0, told.distance, number});
        sheet.write(kValuesOfHit * index + 1, told.location);
        sheet.write(kValuesOfHit * index + 2, told.normal);
    }

    void copyPixels(std::size_t repetition, const raytracer::RenderSettings& settings,
                    const raytracer::Image& image) const {
        if (image.width() != settings.imageWidth() || image.height() != settings.imageHeight()) {
            sheet.sayWrongSize();
            return;
        }
        std::size_t index = repetition * image.pixels().size();
        for (const ColourRGB& colour : image.pixels())
            sheet.write(index++, colour);
    }
};

// All memory is freed before this returns, so that an operator delete of the submission's own runs
// before `SheetHeader::finished` is set.
void answerAll(const std::vector<Question>& questions, std::span<std::byte> memory) {
    const AnswerLayout layout = layoutFor(questions);
    if (memory.size() < layout.totalBytes)
        throw raytracer::Error("the answer memory is smaller than the answers");
    Scenes scenes;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        AnswerSheet sheet{memory, layout.places[i]};
        std::visit(Reply{sheet, scenes}, questions[i]);
    }
}

}  // namespace

// The default if the exercise has no Calls.cpp, which would replace this weak symbol: no calls.
[[gnu::weak]] std::span<const Call> calls() {
    return {};
}

void respond(const std::vector<Question>& questions, std::span<std::byte> memory) {
    answerAll(questions, memory);
    const SheetHeader finished{kSheetFinished};
    std::memcpy(memory.data(), &finished, sizeof finished);
}

}  // namespace ticker::probe
