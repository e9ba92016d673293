#include "Options.h"

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>
#include <raytracer/io/PathOf.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace raytracer {
namespace {

// Largest side of a picture that the kit can read again.
constexpr std::uint64_t kLargestSide = 16'384;
constexpr std::uint64_t kMostPixels = 64'000'000;
constexpr std::uint64_t kMostRays = 1'000'000;
// Each bounce is a nested call, so the stack limits them.
constexpr std::uint64_t kMostBounces = 100;
constexpr std::uint64_t kMostThreads = 1024;
constexpr double kLargestLength = 1e6;

[[noreturn]] void fail(const std::string& message) {
    throw InputError("", 0, message + " (see " TICK1STAR_PROGRAM " --help)");
}

/// The value of an option; `fail` includes the option's name in its error.
struct Value {
    std::string_view option;
    std::string_view text;
};

[[noreturn]] void fail(const Value& value, const std::string& expected) {
    fail(std::string(value.option) + ": found " + inQuotes(value.text) + ", expected " + expected);
}

/// One option: its spelling, its value and its effect.
struct Option {
    std::string_view name;       // "--seed"
    std::string_view shortName;  // "-s", or empty
    std::string_view value;      // name of the value in --help; empty: the option has no value
    std::string_view help;
    void (*apply)(Options&, const Value& value);
};

std::uint64_t countIn(const Value& value, std::uint64_t low, std::uint64_t high) {
    const std::optional<std::uint64_t> count = parseCount(value.text);
    if (!count || *count < low || *count > high)
        fail(value, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return *count;
}

int smallCount(const Value& value, std::uint64_t low, std::uint64_t high) {
    return static_cast<int>(countIn(value, low, high));
}

double lengthOf(const Value& value, bool zeroIsAllowed) {
    const std::optional<double> length = parseNumber(value.text);
    if (!length || *length < 0.0 || (*length == 0.0 && !zeroIsAllowed) || *length > kLargestLength)
        fail(value, zeroIsAllowed ? "a number from 0 to 1e6" : "a number above 0, up to 1e6");
    return *length;
}

std::vector<Value> split(const Value& value, char separator) {
    std::vector<Value> parts;
    std::string_view rest = value.text;
    for (std::size_t end = rest.find(separator); end != std::string_view::npos;
         end = rest.find(separator)) {
        parts.push_back({value.option, rest.substr(0, end)});
        rest.remove_prefix(end + 1);
    }
    parts.push_back({value.option, rest});
    return parts;
}

void setSize(Options& options, const Value& value) {
    const std::vector<Value> parts = split(value, 'x');
    if (parts.size() != 2) fail(value, "WIDTHxHEIGHT as in 640x480");
    const std::uint64_t width = countIn(parts[0], 1, kLargestSide);
    const std::uint64_t height = countIn(parts[1], 1, kLargestSide);
    if (width * height > kMostPixels) fail(value, "at most 64 million pixels");
    options.settings.width = static_cast<int>(width);
    options.settings.height = static_cast<int>(height);
}

void setRegion(Options& options, const Value& value) {
    const std::vector<Value> parts = split(value, ',');
    if (parts.size() != 4) fail(value, "X,Y,WIDTH,HEIGHT as in 0,0,64,48");
    options.settings.region = {
        smallCount(parts[0], 0, kLargestSide), smallCount(parts[1], 0, kLargestSide),
        smallCount(parts[2], 1, kLargestSide), smallCount(parts[3], 1, kLargestSide)};
}

void setTrace(Options& options, const Value& value) {
    const std::vector<Value> parts = split(value, ',');
    if (parts.size() != 2) fail(value, "X,Y as in 320,240");
    options.trace = {smallCount(parts[0], 0, kLargestSide), smallCount(parts[1], 0, kLargestSide)};
}

constexpr auto kOptions = std::to_array<Option>({
    {"--input", "-i", "SCENE", "the scene file (XML)",
     [](Options& o, const Value& value) { o.scene = pathOf(value.text); }},
    {"--output", "-o", "IMAGE", "the picture to write (PNG)",
     [](Options& o, const Value& value) { o.image = pathOf(value.text); }},
    {"--resolution", "-r", "WxH", "size of the full frame in pixels, 640x480 if not given",
     setSize},
    {"--bounces", "-b", "N", "reflections to follow, 2 if not given",
     [](Options& o, const Value& value) {
         o.settings.bounces = smallCount(value, 0, kMostBounces);
     }},
    {"--seed", "", "S", "the same seed gives the same picture; another one each time if not given",
     [](Options& o, const Value& value) { o.seed = countIn(value, 0, UINT64_MAX); }},
    {"--threads", "", "N", "threads to work on, one for each core if not given",
     [](Options& o, const Value& value) { o.threads = smallCount(value, 1, kMostThreads); }},
    {"--region", "", "X,Y,W,H", "render only these pixels of the full frame", setRegion},
    {"--preview", "-p", "", "draw the picture in the terminal while it comes",
     [](Options& o, const Value&) { o.preview = true; }},
    {"--view", "", "", "show the picture in the browser, with its rays; see README.md",
     [](Options& o, const Value&) { o.view = true; }},
    {"--trace", "", "X,Y", "render no picture, but tell what happens at this pixel", setTrace},
    {"--normals", "", "", "show normals as colours: red right, green up, blue towards the eye",
     [](Options& o, const Value&) { o.normals = true; }},
    {"--compare", "", "IMAGE", "say how far the picture is from this one; also as a picture",
     [](Options& o, const Value& value) { o.compare = pathOf(value.text); }},
    {"--shadow-rays", "", "N", "shadow rays for each point and light, 10 if not given",
     [](Options& o, const Value& value) {
         o.settings.shadowRayCount = smallCount(value, 1, kMostRays);
     }},
    {"--light-size", "", "R", "radius of the lights, 0.4 if not given",
     [](Options& o, const Value& value) { o.settings.lightSize = lengthOf(value, true); }},
    {"--dof-rays", "", "N", "camera rays for each pixel, 50 if not given",
     [](Options& o, const Value& value) {
         o.settings.dofRayCount = smallCount(value, 1, kMostRays);
     }},
    {"--aperture", "", "A", "size of the aperture, 0.2 if not given",
     [](Options& o, const Value& value) { o.settings.dofAmount = lengthOf(value, true); }},
    {"--focal-plane", "", "Z", "z of the plane in focus, 3.51805 if not given",
     [](Options& o, const Value& value) { o.settings.dofFocalPlane = lengthOf(value, false); }},
    {"--pinhole", "", "", "neither lens nor soft shadows: the picture of option 1",
     [](Options& o, const Value&) {
         o.settings.dofRayCount = 1;
         o.settings.dofAmount = 0.0;
         o.settings.shadowRayCount = 1;
         o.settings.lightSize = 0.0;
     }},
    {"--assets", "", "DIR", "where bump maps are that do not lie beside the scene",
     [](Options& o, const Value& value) { o.assets = pathOf(value.text); }},
    {"--linear", "", "FILE", "also write the linear colours, as a PFM file",
     [](Options& o, const Value& value) { o.linear = pathOf(value.text); }},
    {"--quiet", "-q", "", "no progress bar, no remarks",
     [](Options& o, const Value&) { o.quiet = true; }},
    {"--verbose", "-v", "", "say the seed, the threads and the time",
     [](Options& o, const Value&) { o.verbose = true; }},
    {"--help", "-h", "", "this text", [](Options& o, const Value&) { o.showHelp = true; }},
    {"--version", "", "", "the version", [](Options& o, const Value&) { o.showVersion = true; }},
});

const Option& optionCalled(std::string_view name) {
    std::vector<std::string_view> names;
    names.reserve(kOptions.size());
    for (const Option& option : kOptions) {
        const bool isShort = !option.shortName.empty() && name == option.shortName;
        if (isShort || name == option.name) return option;
        names.push_back(option.name);
    }
    const std::optional<std::string_view> nearest = nearestName(name, names);
    fail("unknown option " + inQuotes(name) +
         (nearest ? "; did you mean " + std::string(*nearest) + "?" : ""));
}

bool endsInPng(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return extension == ".png";
}

void checkTogether(const Options& options) {
    if (options.showHelp || options.showVersion) return;
    if (options.scene.empty() && !options.view) fail("no scene given; add -i SCENE");
    if (options.image.empty() && !options.trace && !options.view)
        fail("no picture to write given; add -o IMAGE");
    if (!options.image.empty() && !endsInPng(options.image))
        fail("-o " + inQuotes(options.image.string()) + ": expected a name that ends in .png");
    const RenderSettings& settings = options.settings;
    const Region& region = settings.region;
    const std::string frame = "the full frame of " + std::to_string(settings.width) + "x" +
                              std::to_string(settings.height) + " pixels";
    if (region.x + region.width > settings.width || region.y + region.height > settings.height)
        fail("--region reaches beyond " + frame);
    if (options.trace &&
        (options.trace->x >= settings.width || options.trace->y >= settings.height))
        fail("--trace asks for a pixel beyond " + frame);
    if (options.normals && !options.linear.empty())
        fail("--normals gives no linear colours; leave --linear out");
}

}  // namespace

Options parseOptions(std::span<const std::string> arguments) {
    Options options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        if (options.view && options.scene.empty() && !argument.starts_with('-')) {
            options.scene = pathOf(argument);  // --view SCENE
            continue;
        }
        const std::size_t equals =
            argument.starts_with("--") ? argument.find('=') : std::string_view::npos;
        const Option& option = optionCalled(argument.substr(0, equals));
        if (option.value.empty()) {
            if (equals != std::string_view::npos)
                fail(std::string(option.name) + " takes no value");
            option.apply(options, {option.name, {}});
        } else if (equals != std::string_view::npos) {
            option.apply(options, {option.name, argument.substr(equals + 1)});
        } else {
            if (i + 1 == arguments.size())
                fail(std::string(argument) + " needs a value: " + std::string(option.value));
            option.apply(options, {option.name, arguments[++i]});
        }
    }
    checkTogether(options);
    return options;
}

std::string usage() {
    constexpr std::size_t kColumn = 28;
    std::string text =
        "Renders a scene to a picture.\n\n"
        "  " TICK1STAR_PROGRAM " -i SCENE -o IMAGE [options]\n\n";
    for (const Option& option : kOptions) {
        std::string line = "  ";
        if (!option.shortName.empty()) line += std::string(option.shortName) + ", ";
        line += option.name;
        line += option.value.empty() ? "" : " ";
        line += option.value;
        line.resize(std::max(kColumn, line.size() + 2), ' ');
        text += line + std::string(option.help) + "\n";
    }
    return text +
           "\nExit status: 0 done, 2 wrong usage or unreadable input, 3 a failure of the program, "
           "130 interrupted.\nCtrl-C keeps the rows that are done.\n";
}

}  // namespace raytracer
