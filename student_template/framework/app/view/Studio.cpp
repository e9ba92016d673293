#include "Studio.h"

#include "../Inputs.h"
#include "Json.h"
#include "Lines.h"

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <array>
#include <chrono>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

namespace raytracer::view {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kLookEvery{50};

/// The page's controls, and the options of tick1star that they stand for.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kControls{
    {{"size", "--resolution"},
     {"bounces", "--bounces"},
     {"seed", "--seed"},
     {"shadowRays", "--shadow-rays"},
     {"lightSize", "--light-size"},
     {"dofRays", "--dof-rays"},
     {"aperture", "--aperture"},
     {"focalPlane", "--focal-plane"}}};

std::map<std::string, std::string> settingsOfOptions(const Options& options) {
    const RenderSettings settings = settingsOf(options);
    return {{"scene", options.scene.filename().string()},
            {"size", std::to_string(settings.width) + "x" + std::to_string(settings.height)},
            {"bounces", std::to_string(settings.bounces)},
            {"seed", options.seed ? std::to_string(*options.seed) : "1"},
            {"shadowRays", std::to_string(settings.shadowRayCount)},
            {"lightSize", json(settings.lightSize)},
            {"dofRays", std::to_string(settings.dofRayCount)},
            {"aperture", json(settings.dofAmount)},
            {"focalPlane", json(settings.dofFocalPlane)}};
}

std::vector<std::string> otherOptions(const Options& options) {
    std::vector<std::string> others;
    if (!options.assets.empty()) others.insert(others.end(), {"--assets", options.assets.string()});
    if (options.threads)
        others.insert(others.end(), {"--threads", std::to_string(*options.threads)});
    return others;
}

std::vector<std::string> argumentsOf(const fs::path& scenes,
                                     const std::map<std::string, std::string>& settings) {
    std::vector<std::string> arguments{"--view", "--input",
                                       (scenes / settings.at("scene")).string()};
    for (const auto& [control, option] : kControls) {
        arguments.emplace_back(option);
        arguments.push_back(settings.at(std::string{control}));
    }
    return arguments;
}

}  // namespace

Studio::Studio(const ViewHome& home, const Options& options)
    : home_(home),
      scenes_(options.scene.has_parent_path() ? options.scene.parent_path() : fs::path(".")),
      firstScene_(options.scene.filename().string()),
      others_(otherOptions(options)),
      settings_(settingsOfOptions(options)),
      runner_(home.program,
              {[this](int number, const std::string& payload) { hearPart(number, payload); },
               [this](const std::string& words) { board_.set("trouble", json(words)); }}),
      workshop_(home, board_, {[this] { pause(); }, [this] { takeProgram(); }, [this] { goOn(); }}),
      clock_([this] {
          while (!isEnding_) {
              workshop_.look();
              runner_.look();
              std::this_thread::sleep_for(kLookEvery);
          }
      }) {
    Items names;
    for (const std::string& name : scenes())
        names.add(json(name));
    board_.set("scenes", names.array());
    if (!home_.hasLens) settings_["aperture"] = "0";
    board_.set("hasLens", home_.hasLens ? "true" : "false");
    board_.set("started", settingsJson());
    render();
}

Studio::~Studio() {
    isEnding_ = true;
    clock_.join();
    board_.close();
}

void Studio::change(const std::map<std::string, std::string>& changes) {
    {
        const std::lock_guard lock{mutex_};
        std::map<std::string, std::string> changed = settings_;
        for (const auto& [name, value] : changes) {
            if (!changed.contains(name)) throw InputError("", 0, "there is no setting " + name);
            if (value.find_first_of("\t\n") != std::string::npos)
                throw InputError("", 0, name + ": one value is expected");
            changed[name] = value;
        }
        if (!scenes().contains(changed["scene"]))
            throw InputError("", 0, "there is no scene " + inQuotes(changed["scene"]));
        static_cast<void>(parseOptions(argumentsOf(scenes_, changed)));
        settings_ = changed;
    }
    render();
}

std::set<std::string> Studio::scenes() const {
    std::set<std::string> names{firstScene_};  // whatever its name ends in
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator{scenes_, error})
        if (entry.path().extension() == ".xml") names.insert(entry.path().filename().string());
    return names;
}

std::vector<std::string> Studio::arguments() {
    const std::lock_guard lock{mutex_};
    return argumentsWhileLocked();
}

std::vector<std::string> Studio::argumentsWhileLocked() const {
    std::vector<std::string> arguments = argumentsOf(scenes_, settings_);
    arguments.insert(arguments.end(), others_.begin(), others_.end());
    return arguments;
}

std::string Studio::settingsJson() const {
    Members members;
    for (const auto& [name, value] : settings_)
        members.add(name, json(value));
    return members.object();
}

void Studio::render() {
    std::vector<std::string> asked;
    int number = 0;
    {
        // The newest picture has to have the newest settings.
        const std::lock_guard lock{mutex_};
        asked = argumentsWhileLocked();
        number = ++pictures_;
        isWhole_ = isPaused_ = false;
        const RenderSettings settings = parseOptions(asked).settings;
        board_.set("trouble", json(""));
        board_.beginPicture(number, Members{}
                                        .add("number", std::to_string(number))
                                        .add("build", std::to_string(builds_))
                                        .add("width", std::to_string(settings.width))
                                        .add("height", std::to_string(settings.height))
                                        .add("settings", settingsJson())
                                        .object());
    }
    runner_.render(number, asked);
}

void Studio::pause() {
    {
        const std::lock_guard lock{mutex_};
        if (isWhole_) return;
        isPaused_ = true;
    }
    runner_.restart();
}

void Studio::takeProgram() {
    runner_.restart();
    {
        const std::lock_guard lock{mutex_};
        ++builds_;
    }
    render();
}

void Studio::goOn() {
    {
        const std::lock_guard lock{mutex_};
        if (!isPaused_) return;
    }
    render();
}

void Studio::hearPart(int number, const std::string& payload) {
    const std::size_t end = payload.find('\n');
    const std::vector<std::string> words = splitAt(payload.substr(0, end), ' ');
    constexpr std::array<const char*, 8> kNames{"x",      "y",    "width", "height",
                                                "across", "down", "last",  "left"};
    if (end == std::string::npos || words.size() < kNames.size()) return;
    Members head;
    for (std::size_t i = 0; i < kNames.size(); ++i)
        head.add(kNames[i], json(parseNumber(words[i]).value_or(0.0)));
    std::string stage;
    for (std::size_t i = kNames.size(); i < words.size(); ++i)
        stage += (stage.empty() ? "" : " ") + words[i];
    head.add("stage", json(stage));
    constexpr std::size_t kLast = 6;
    if (words[kLast] == "1") {
        const std::lock_guard lock{mutex_};
        if (number == pictures_) isWhole_ = true;
    }
    board_.addPiece(number, {head.object(), payload.substr(end + 1), !stage.empty()});
}

SolutionRunner::Answer Studio::pixel(const std::string& x, const std::string& y) {
    std::vector<std::string> asked = arguments();
    const RenderSettings settings = parseOptions(asked).settings;
    const auto column = parseCount(x);
    const auto row = parseCount(y);
    if (!column || !row || *column >= static_cast<std::uint64_t>(settings.width) ||
        *row >= static_cast<std::uint64_t>(settings.height))
        return {false, "there is no such pixel"};
    asked.insert(asked.begin(), {x, y});
    return runner_.ask("pixel", asked);
}

SolutionRunner::Answer Studio::point(const std::string& x, const std::string& y,
                                     const std::string& z) {
    if (!parseNumber(x) || !parseNumber(y) || !parseNumber(z)) return {false, "no such point"};
    std::vector<std::string> asked = arguments();
    asked.insert(asked.begin(), {x, y, z});
    return runner_.ask("point", asked);
}

SolutionRunner::Answer Studio::pinhole() {
    std::vector<std::string> asked = arguments();
    asked.emplace_back("--pinhole");
    SolutionRunner::Answer answer = runner_.ask("whole", asked);
    if (answer.isGood) answer.payload.erase(0, answer.payload.find('\n') + 1);
    return answer;
}

}  // namespace raytracer::view
