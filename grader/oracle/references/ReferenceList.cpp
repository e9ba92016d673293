#include <grader/oracle/references/ReferenceList.h>

#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/SceneReader.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace ticker::oracle {
namespace {

namespace fs = std::filesystem;
// The type that Manifest.cpp uses, too: one template instantiation less to compile.
using json = nlohmann::ordered_json;

// Larger references would be too big for the repository: a pixel takes more than four floats.
constexpr int kLargestPicture = 640;

json parse(const fs::path& file) {
    const json document = json::parse(readWhole(file), nullptr, false);
    if (!document.is_object() || document.size() != 1 || !document.contains("references") ||
        !document.at("references").is_array())
        throw raytracer::InputError(file.string(), 0,
                                    "must be JSON of the form {\"references\": [...]}");
    return document.at("references");
}

bool isSide(const json& entry, const char* name) {
    return entry.contains(name) && entry.at(name).is_number_integer() && entry.at(name) > 0 &&
           entry.at(name) <= kLargestPicture;
}

ReferenceScene readEntry(const json& entry, const std::string& where, const fs::path& scenes,
                         const fs::path& assets) {
    const bool fits = entry.is_object() && entry.size() == 4 && entry.contains("scene") &&
                      entry.at("scene").is_string() && entry.contains("pinhole") &&
                      entry.at("pinhole").is_boolean() && isSide(entry, "width") &&
                      isSide(entry, "height");
    if (!fits)
        throw raytracer::InputError(
            where, 0,
            fmt::format("must hold \"scene\", the name of a scene, \"pinhole\", true or false, and "
                        "\"width\" and \"height\" from 1 to {}, and nothing else: {}",
                        kLargestPicture, entry.dump()));
    ReferenceScene scene;
    scene.name = entry.at("scene");
    scene.scene = raytracer::readScene(scenes / (scene.name + ".xml"), assets);
    scene.settings.width = entry.at("width");
    scene.settings.height = entry.at("height");
    scene.pinhole = entry.at("pinhole");
    return scene;
}

}  // namespace

std::vector<ReferenceScene> readReferenceList(const fs::path& scenes, const fs::path& assets) {
    const fs::path file = scenes / "references.json";
    std::vector<ReferenceScene> list;
    for (const json& entry : parse(file))
        list.push_back(readEntry(entry,
                                 fmt::format("{}: \"references\"[{}]", file.string(), list.size()),
                                 scenes, assets));
    return list;
}

std::vector<std::string> scenesWithoutReference(const fs::path& scenes,
                                                const std::vector<ReferenceScene>& listed) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator{scenes}) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".xml" &&
            std::ranges::find(listed, name, &ReferenceScene::name) == listed.end())
            names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
}

}  // namespace ticker::oracle
