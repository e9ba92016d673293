#include "Worker.h"

#include "../Inputs.h"
#include "../Options.h"
#include "../PixelLog.h"
#include "DrawingJson.h"
#include "Lines.h"
#include "Stages.h"
#include "process/Process.h"

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>
#include <raytracer/io/SceneReader.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace raytracer::view {
namespace {

struct Command {
    std::string verb;
    std::string number;
    std::vector<std::string> arguments;
};

Command commandOf(const std::string& line) {
    std::vector<std::string> words = splitAt(line, '\t');
    words.resize(std::max<std::size_t>(words.size(), 2));
    return {words[0], words[1], {words.begin() + 2, words.end()}};
}

/// Takes the first `count` arguments, which are numbers, off a command.
std::vector<double> takeNumbers(Command& command, std::size_t count) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count && i < command.arguments.size(); ++i)
        numbers.push_back(parseNumber(command.arguments[i]).value_or(0.0));
    if (numbers.size() < count) throw Error("a number is missing");
    command.arguments.erase(command.arguments.begin(),
                            command.arguments.begin() + static_cast<std::ptrdiff_t>(count));
    return numbers;
}

/// What a command's options say.
struct Task {
    explicit Task(const Command& command)
        : options(parseOptions(command.arguments)),
          description(readScene(options.scene, assetsOf(options))),
          settings(settingsOf(options)) {}

    Options options;
    SceneDescription description;
    RenderSettings settings;
};

std::string headOf(const Part& part) {
    std::string head;
    for (const int number : {part.region.x, part.region.y, part.region.width, part.region.height,
                             part.picture.width, part.picture.height, part.isLast ? 1 : 0})
        head += std::to_string(number) + " ";
    return head + std::to_string(part.secondsLeft) + " " + part.stage + "\n";
}

std::string bytesOf(const ByteImage& picture) {
    return {picture.rgb.begin(), picture.rgb.end()};
}

class Worker {
public:
    [[noreturn]] void run() {
        std::thread{[this] { readCommands(); }}.detach();
        std::thread{[this] { renderPictures(); }}.detach();
        for (;;)
            answer(nextQuestion());
    }

private:
    /// A solution may be busy for ever: that this process has to end is noticed here.
    void readCommands() {
        LineReader lines{
            [this](char* bytes, std::size_t size) { return parent_.read(bytes, size); }};
        while (const std::optional<std::string> line = lines.next()) {
            Command command = commandOf(*line);
            const std::lock_guard lock{mutex_};
            if (command.verb == "picture")
                picture_ = std::move(command);
            else
                questions_.push_back(std::move(command));
            changed_.notify_all();
        }
        std::_Exit(0);
    }

    Command nextQuestion() {
        std::unique_lock lock{mutex_};
        changed_.wait(lock, [this] { return !questions_.empty(); });
        Command command = std::move(questions_.front());
        questions_.pop_front();
        return command;
    }

    Command nextPicture() {
        std::unique_lock lock{mutex_};
        changed_.wait(lock, [this] { return picture_.has_value(); });
        return *std::exchange(picture_, std::nullopt);
    }

    bool isAnotherWanted() {
        const std::lock_guard lock{mutex_};
        return picture_.has_value();
    }

    void renderPictures() {
        yieldToOthers();
        for (;;) {
            const Command command = nextPicture();
            guarded(command, [&] {
                const Task task{command};
                const Scene scene{task.description};
                renderInStages(
                    scene, task.settings, [&](const Part& part) { send(command, part); },
                    [this] { return isAnotherWanted(); });
            });
        }
    }

    void answer(Command command) {
        guarded(command, [&] {
            if (command.verb == "pixel") return answerPixel(command);
            if (command.verb == "point") return answerPoint(command);
            const Task task{command};
            send(command, Part{{0, 0, task.settings.width, task.settings.height},
                               renderWhole(Scene{task.description}, task.settings),
                               {},
                               0.0,
                               true});
        });
    }

    void answerPixel(Command& command) {
        const std::vector<double> at = takeNumbers(command, 2);
        const Task task{command};
        const Pixel pixel{static_cast<int>(at[0]), static_cast<int>(at[1])};
        PixelLog log;
        const Scene scene{task.description, &log};
        RenderSettings settings = task.settings;
        settings.threads = 1;
        settings.region = {pixel.x, pixel.y, 1, 1};
        settings.observer = &log;
        seedRandom(settings.seed);
        static_cast<void>(Renderer{settings}.render(scene));
        send("drawing", command, drawingOfPixel(log, scene, settings, pixel));
    }

    /// The surface that lies nearest to the point is asked about.
    void answerPoint(Command& command) {
        const std::vector<double> at = takeNumbers(command, 3);
        const Task task{command};
        const Vector3 point{at[0], at[1], at[2]};
        PixelLog log;
        const Scene scene{task.description, &log};
        const RaycastHit hit = nearestSurface(scene, point);
        seedRandom(task.settings.seed);
        const ColourRGB colour = Renderer{task.settings}.illuminate(
            scene, *hit.object, hit.location, hit.normal, Vector3{});
        send("drawing", command, drawingOfPoint(log, scene, task.settings, hit, colour));
    }

    static RaycastHit nearestSurface(const Scene& scene, const Vector3& point) {
        RaycastHit nearest;
        double least = std::numeric_limits<double>::infinity();
        for (const auto& object : scene.objects()) {
            Vector3 foot = point;
            if (const auto* sphere = dynamic_cast<const Sphere*>(object.get()))
                foot =
                    sphere->centre() + (point - sphere->centre()).normalised() * sphere->radius();
            else if (const auto* plane = dynamic_cast<const Plane*>(object.get()))
                foot = point - plane->normal() * (point - plane->point()).dot(plane->normal());
            const double away = (foot - point).magnitude();
            if (!(away < least)) continue;
            least = away;
            nearest = {object.get(), foot.magnitude(), foot, {}};
        }
        if (nearest.object == nullptr) throw Error("there is no surface");
        nearest.normal = nearest.object->getNormalAt(nearest.location);
        return nearest;
    }

    template <typename Work>
    void guarded(const Command& command, const Work& work) {
        try {
            work();
        } catch (const std::exception& error) {
            send("failed", command, error.what());
        }
    }

    void send(const Command& command, const Part& part) {
        send("part", command, headOf(part) + bytesOf(part.picture));
    }

    void send(const std::string& kind, const Command& command, const std::string& payload) {
        const std::string head =
            kind + " " + command.number + " " + std::to_string(payload.size()) + "\n";
        const std::lock_guard lock{writing_};
        if (!parent_.write(head + payload)) std::_Exit(0);
    }

    Parent parent_;
    std::mutex writing_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Command> questions_;
    std::optional<Command> picture_;
};

}  // namespace

void runWorker() {
    static Worker worker;  // its threads go on until the process ends
    worker.run();
}

}  // namespace raytracer::view
