#include <grader/lab/calibrate/Parts.h>

#include <grader/base/Digest.h>
#include <grader/base/JsonValue.h>
#include <grader/base/WholeFile.h>
#include <grader/exercise/Exercise.h>
#include <grader/lab/calibrate/CodeOnly.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <cstddef>
#include <set>

namespace ticker::calibrate {
namespace {

namespace fs = std::filesystem;

// Hexadecimal digits of a digest. Few are enough: the probability that two of a hundred versions
// agree by accident is 1e-6.
constexpr std::size_t kDigits = 8;

// The row of "measured" for a task that has none of its own.
constexpr const char* kOtherTask = "any other task";

bool isCode(const fs::path& file) {
    return file.extension() == ".cpp" || file.extension() == ".h";
}

std::vector<std::string> textsOf(const JsonValue& list) {
    std::vector<std::string> texts;
    for (const JsonValue& item : list.items())
        texts.push_back(item.text());
    return texts;
}

bool isTask(std::string_view id) {
    return std::ranges::any_of(
        knownExercises(), [&](const Exercise& exercise) { return exercise.task(id) != nullptr; });
}

// All paths that the table lists.
std::set<std::string> pathsOf(const JsonValue& parts) {
    std::set<std::string> paths;
    for (const auto& [name, list] : parts.members())
        for (const std::string& path : textsOf(list))
            paths.insert(path.substr(path.starts_with('-') ? 1 : 0));
    return paths;
}

// Replaces "FOLDER/*" by the subfolders of FOLDER that the table does not list.
std::vector<std::string> expanded(const std::vector<std::string>& paths, const fs::path& root,
                                  const std::set<std::string>& known) {
    std::vector<std::string> all;
    for (const std::string& path : paths) {
        if (!path.ends_with("/*")) {
            all.push_back(path);
            continue;
        }
        for (const auto& entry : fs::directory_iterator(root / path.substr(0, path.size() - 2))) {
            const std::string folder = entry.path().lexically_relative(root).generic_string();
            if (entry.is_directory() && !known.contains(folder)) all.push_back(folder);
        }
    }
    return all;
}

// The files and the code files below folders that `paths` lists; "-FOLDER" leaves out those of a
// folder.
std::vector<fs::path> filesBelow(const fs::path& root, const std::vector<std::string>& paths,
                                 const JsonValue& place) {
    std::vector<fs::path> files;
    for (const std::string& path : paths) {
        if (path.starts_with('-')) {
            std::erase_if(files, [&](const fs::path& file) {
                return file.string().starts_with(path.substr(1) + "/");
            });
            continue;
        }
        if (!fs::exists(root / path)) place.refuse(path + " is not there");
        if (!fs::is_directory(root / path)) files.emplace_back(path);
        if (fs::is_directory(root / path))
            for (const auto& entry : fs::recursive_directory_iterator(root / path))
                if (isCode(entry.path())) files.push_back(entry.path().lexically_relative(root));
    }
    std::ranges::sort(files);
    return files;
}

std::string digestOf(const fs::path& root, const std::vector<fs::path>& files) {
    Digest digest;
    for (const fs::path& file : files) {
        const std::string text = readWhole(root / file);
        digest.add(file.generic_string()).add(isCode(file) ? codeOnly(text) : text);
    }
    return digest.text().substr(0, kDigits);
}

}  // namespace

Parts::Parts(const fs::path& root) : table_(root / "grader/lab/calibrate/parts.json") {
    const JsonValue whole = JsonValue::parse(readWhole(table_), table_.string());
    whole.allowOnly({"parts", "measured"});
    const std::set<std::string> known = pathsOf(whole.at("parts"));
    for (const auto& [name, list] : whole.at("parts").members()) {
        Part part;
        part.paths = expanded(textsOf(list), root, known);
        part.files = filesBelow(root, part.paths, list);
        part.digest = digestOf(root, part.files);
        parts_.emplace(name, std::move(part));
    }
    for (const auto& [name, list] : whole.at("measured").members())
        for (const JsonValue& part : list.items()) {
            if (!parts_.contains(part.text())) part.expect("the name of a part");
            measured_[name].push_back(part.text());
        }
}

const std::vector<std::string>& Parts::partsOf(std::string_view measured) const {
    auto found = measured_.find(measured);
    if (found == measured_.end() && isTask(measured)) found = measured_.find(kOtherTask);
    if (found == measured_.end())
        throw raytracer::InputError(table_.string(), 0,
                                    "\"measured\" has no \"" + std::string{measured} +
                                        "\": list the parts that its result depends on");
    return found->second;
}

Stamp Parts::stampOf(std::string_view measured) const {
    Stamp stamp;
    for (const std::string& part : partsOf(measured))
        stamp.emplace(part, parts_.at(part).digest);
    return stamp;
}

std::vector<fs::path> Parts::filesOf(std::string_view measured) const {
    std::vector<fs::path> files;
    for (const std::string& part : partsOf(measured))
        files.insert(files.end(), parts_.at(part).files.begin(), parts_.at(part).files.end());
    return files;
}

std::string Parts::placeOf(const std::string& part) const {
    constexpr std::size_t kFew = 2;
    const auto found = parts_.find(part);
    if (found == parts_.end() || found->second.paths.size() > kFew) return "the part " + part;
    return found->second.paths.front();
}

std::string shortDigest(std::string_view text) {
    return Digest{}.add(text).text().substr(0, kDigits);
}

}  // namespace ticker::calibrate
