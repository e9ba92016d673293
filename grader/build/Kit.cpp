#include <grader/build/Kit.h>

#include <grader/base/JsonValue.h>
#include <grader/base/WholeFile.h>
#include <grader/sandbox/HelperProgram.h>
#include <grader/sandbox/Sandbox.h>
#include <grader/sandbox/StagingFolder.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>

#include <unistd.h>

#include <algorithm>

namespace ticker::build {
namespace fs = std::filesystem;
namespace {

std::string readPart(const fs::path& file) {
    auto text = readIfThere(file);
    if (!text) throw raytracer::Error(fmt::format("the kit lacks {}", file.string()));
    return std::move(*text);
}

// What every user needs to read a file, or to list and pass through a folder.
fs::perms openTo(const fs::directory_entry& entry) {
    return entry.is_directory() ? fs::perms{0555} : fs::perms{0444};
}

// True if every user can read all that lies in the folder: a checkout that was made under a umask
// such as 027 may hold private files in an open folder.
bool everybodyReads(const fs::path& folder) {
    if (geteuid() != 0) return true;
    const auto isOpen = [](const fs::directory_entry& entry) {
        const fs::perms others = openTo(entry) & fs::perms::others_all;
        return (entry.status().permissions() & others) == others;
    };
    return isOpen(fs::directory_entry{folder}) &&
           std::ranges::all_of(fs::recursive_directory_iterator{folder}, isOpen);
}

fs::path copyForEverybody(const fs::path& folder) {
    fs::path copy = sandbox::Sandbox::makeStagingFolder() / "kit";
    try {
        fs::copy(folder, copy, fs::copy_options::recursive);
        // The copies have the modes of the originals, without what the umask takes away.
        const auto open = [](const fs::directory_entry& entry) {
            fs::permissions(entry.path(), openTo(entry), fs::perm_options::add);
        };
        open(fs::directory_entry{copy});
        std::ranges::for_each(fs::recursive_directory_iterator{copy}, open);
    } catch (const fs::filesystem_error& error) {
        throw raytracer::Error(sandbox::cannotStage(folder, error.code()));
    }
    return copy;
}

std::vector<std::string> textsOf(const JsonValue& list) {
    std::vector<std::string> texts;
    for (const JsonValue& item : list.items())
        texts.push_back(item.text());
    return texts;
}

}  // namespace

Kit Kit::besideProgram(const Exercise& exercise) {
    const fs::path prefix = fs::read_symlink("/proc/self/exe").parent_path().parent_path();
    const fs::path installed = prefix / "lib" / "ticker" / "kit";
    return at((fs::is_directory(installed) ? installed : prefix / "kit") / exercise.name);
}

Kit Kit::at(const fs::path& folder) {
    const fs::path file = folder / "kit.json";
    const std::string text = readPart(file);
    Kit kit;
    const JsonValue json = JsonValue::parse(text, file.string());
    if (json.at("version").number() != 1)
        throw raytracer::Error(fmt::format("{}: not a kit of version 1", file.string()));
    kit.madeAt_ = json.at("madeAt").text();
    kit.compiler_ = json.at("compiler").text();
    kit.compileFlags_ = textsOf(json.at("compile"));
    kit.quickFlags_ = textsOf(json.at("quick"));
    kit.linkFlags_ = textsOf(json.at("link"));
    kit.files_ = textsOf(json.at("files"));
    std::vector<std::string> parts{"lib/libkit.a", "lib/probe.o", "pch/Framework.h.gch"};
    for (const std::string& name : kit.files_)
        parts.push_back(templateObject(name));
    for (const std::string& part : parts)
        if (!fs::is_regular_file(folder / part))
            throw raytracer::Error(fmt::format("the kit lacks {}", (folder / part).string()));
    const fs::path whole = fs::canonical(folder);
    kit.folder_ =
        sandbox::jobsCanReach(whole) && everybodyReads(whole) ? whole : copyForEverybody(whole);
    return kit;
}

fs::path Kit::parsedHeader() const {
    const fs::path file = folder_ / "pch" / "Framework.pch";
    return folder_ == madeAt_ && fs::is_regular_file(file) ? file : fs::path{};
}

std::string Kit::templateSource(const std::string& file) const {
    return readPart(folder_ / "template" / file);
}

std::string Kit::templateObject(const std::string& file) {
    return "template/" + fs::path{file}.stem().string() + ".o";
}

}  // namespace ticker::build
