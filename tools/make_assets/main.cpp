// Generates the bump maps in assets/, or checks that the committed ones equal the generated ones.
#include "LetterAsset.h"
#include "SkinMap.h"

#include <raytracer/base/Error.h>
#include <raytracer/io/ImageWriter.h>

#include <array>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using raytracer::ByteImage;
using raytracer::ExitCode;

struct Asset {
    std::string_view name;
    ByteImage (*make)();
};

constexpr auto kAssets = std::to_array<Asset>(
    {{"bumpmap-test.png", assets::makeLetterMap}, {"bumpmap.png", assets::makeSkinMap}});

// Compares pixels instead of files: compression depends on the version of the PNG writer.
bool isAsMade(const std::filesystem::path& file, const ByteImage& made) {
    const ByteImage found = raytracer::readImage(file);
    const bool same =
        found.width == made.width && found.height == made.height && found.rgb == made.rgb;
    std::cout << file.string() << (same ? ": as made\n" : ": differs from what is made\n");
    return same;
}

ExitCode run(const std::vector<std::string>& arguments) {
    const bool check = arguments.size() == 2 && arguments[0] == "--check";
    if (!check && (arguments.size() != 1 || arguments[0].starts_with("-")))
        throw raytracer::InputError("", 0, "expected: make_assets [--check] FOLDER");
    bool allSame = true;
    for (const Asset& asset : kAssets) {
        const std::filesystem::path file = std::filesystem::path(arguments.back()) / asset.name;
        if (check)
            allSame = isAsMade(file, asset.make()) && allSame;
        else
            raytracer::writePng(asset.make(), file);
    }
    return allSame ? ExitCode::success : ExitCode::checkFailed;
}

}  // namespace

int main(int argc, char* argv[]) {
    try {
        return raytracer::toInt(run({argv + 1, argv + argc}));
    } catch (const raytracer::Error& error) {
        std::cerr << "make_assets: " << error.what() << '\n';
        return raytracer::toInt(error.exitCode());
    } catch (const std::exception& error) {
        std::cerr << "make_assets: " << error.what() << '\n';
        return raytracer::toInt(ExitCode::notGradable);
    }
}
