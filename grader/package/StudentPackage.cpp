#include <grader/base/WholeFile.h>
#include <grader/package/CheckJson.h>
#include <grader/package/StudentPackage.h>
#include <grader/zip/ZipWriter.h>

#include <raytracer/base/Error.h>

#include <array>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

namespace ticker::package {
namespace {

namespace fs = std::filesystem;

// The parts are listed one by one, so that build folders and the like are left out.
constexpr std::array kFolders{".devcontainer", ".vscode", "cmake", "framework", "tests"};
constexpr std::array kFiles{".clangd",           ".gitattributes", ".gitignore", "CMakeLists.txt",
                            "CMakePresets.json", "README.md",      "check",      "check.cmd",
                            "check.json",        "vcpkg.json"};

// The list of tasks and pictures that ./check works through.
constexpr std::string_view kDescription = "check.json";

/// The regular files that an iterator of folders gives.
/// @throws raytracer::InputError if a folder cannot be read.
template <typename Iterator>
std::set<fs::path> filesOfFolder(const fs::path& folder) {
    std::set<fs::path> files;
    std::error_code error;
    std::error_code ofFile;
    for (Iterator at{folder, error}; !error && at != Iterator{}; at.increment(error))
        if (at->is_regular_file(ofFile)) files.insert(at->path());
    if (error)
        throw raytracer::InputError(folder.string(), 0, "cannot be read: " + error.message());
    return files;
}

/// Collects the files of a student's package.
class Package {
public:
    Package(const fs::path& data, const Exercise& exercise, const fs::path& file)
        : data_(data), exercise_(exercise), root_(exercise.name + "/"), zip_(file) {}

    void write() {
        addTemplate();
        if (exercise_.overlay.empty()) {
            addKind("scenes", ".xml");
            addKind("assets", ".png");
        } else {
            for (const SceneEntry& scene : exercise_.scenes)
                zip_.addFile(root_ + "scenes/" + scene.name + ".xml",
                             data_ / "scenes" / (scene.name + ".xml"));
        }
        addHandout();
        // An installation may have its licence in another folder.
        std::error_code error;
        if (fs::is_regular_file(data_ / "LICENSE", error))
            zip_.addFile(root_ + "LICENSE", data_ / "LICENSE");
        zip_.finish();
    }

private:
    void addTemplate() {
        const fs::path folder = data_ / "student_template";
        std::map<std::string, fs::path> files;
        for (const char* name : kFolders)
            collect(folder, folder / name, files);
        for (const char* name : kFiles)
            files[name] = folder / name;
        if (!exercise_.overlay.empty()) {
            std::erase_if(files, [&](const auto& one) { return isLeftOut(one.first); });
            collect(data_ / exercise_.overlay, data_ / exercise_.overlay, files);
        }
        collect((data_ / exercise_.stubs).parent_path(), data_ / exercise_.stubs, files);
        for (const auto& [name, file] : files)
            if (name == kDescription)
                zip_.add(root_ + name, withEveryTask(readWhole(file), exercise_));
            else
                zip_.addFile(root_ + name, file);
    }

    /// True for what students write themselves, and for the public tests of another exercise.
    [[nodiscard]] bool isLeftOut(const std::string& name) const {
        return name.starts_with("framework/src/" + exercise_.leftOut + "/") ||
               (name.starts_with("tests/") && !name.starts_with("tests/support/"));
    }

    /// Adds the files below `folder`, under their paths in `top`; a later file replaces an earlier
    /// one.
    static void collect(const fs::path& top, const fs::path& folder,
                        std::map<std::string, fs::path>& files) {
        for (const fs::path& file : filesOfFolder<fs::recursive_directory_iterator>(folder))
            files[file.lexically_relative(top).generic_string()] = file;
    }

    /// Adds the files of one kind directly in a folder, without subfolders: assets/references/ is
    /// not handed out.
    void addKind(const std::string& name, const std::string& extension) {
        for (const fs::path& found : filesOfFolder<fs::directory_iterator>(data_ / name))
            if (found.extension() == extension)
                zip_.addFile(root_ + name + "/" + found.filename().string(), found);
    }

    /// Adds the handout and the pictures in it.
    void addHandout() {
        const fs::path handout = data_ / exercise_.handout;
        const auto read = readIfThere(handout);
        if (!read) return;  // a course may use its own handout
        const std::string& text = *read;
        zip_.add(root_ + "handout.md", text);
        static const std::regex kPicture{R"(\]\((images/[A-Za-z0-9._-]+)\))"};
        std::set<std::string> pictures;
        for (std::sregex_iterator at{text.begin(), text.end(), kPicture};
             at != std::sregex_iterator{}; ++at)
            pictures.insert((*at)[1]);
        for (const std::string& picture : pictures)
            zip_.addFile(root_ + picture, handout.parent_path() / picture);
    }

    const fs::path& data_;
    const Exercise& exercise_;
    std::string root_;
    zip::ZipWriter zip_;
};

}  // namespace

void writeStudentPackage(const fs::path& data, const Exercise& exercise, const fs::path& file) {
    Package{data, exercise, file}.write();
}

}  // namespace ticker::package
