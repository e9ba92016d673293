#include <grader/base/WholeFile.h>
#include <grader/package/StudentPackage.h>
#include <grader/zip/ZipWriter.h>

#include <array>
#include <regex>
#include <set>
#include <string>

namespace ticker::package {
namespace {

namespace fs = std::filesystem;

const std::string kRoot = "tick1star/";

// Listed one by one, so that other things in the folder, such as a build, are left out.
constexpr std::array kFolders{".devcontainer", ".vscode",   "cmake",
                              "exercise",      "framework", "tests"};
constexpr std::array kFiles{".clangd",   "CMakeLists.txt", "CMakePresets.json",
                            "README.md", "check",          "vcpkg.json"};

void addTemplate(zip::ZipWriter& zip, const fs::path& folder) {
    for (const char* name : kFolders)
        zip.addFolder(kRoot + name, folder / name);
    for (const char* name : kFiles)
        zip.addFile(kRoot + name, folder / name);
}

/// Adds the files of one kind directly in a folder, without subfolders: assets/references/ is not
/// handed out.
void addKind(zip::ZipWriter& zip, const std::string& name, const fs::path& folder,
             const std::string& extension) {
    std::set<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator{folder})
        if (entry.is_regular_file() && entry.path().extension() == extension)
            files.insert(entry.path());
    for (const fs::path& found : files)
        zip.addFile(kRoot + name + "/" + found.filename().string(), found);
}

/// Adds the handout and the pictures in it.
void addHandout(zip::ZipWriter& zip, const fs::path& docs) {
    const fs::path handout = docs / "handout.md";
    const auto read = readIfThere(handout);
    if (!read) return;  // a course may use its own handout
    const std::string& text = *read;
    zip.add(kRoot + "handout.md", text);
    static const std::regex kPicture{R"(\]\((images/[A-Za-z0-9._-]+)\))"};
    std::set<std::string> pictures;
    for (std::sregex_iterator at{text.begin(), text.end(), kPicture}; at != std::sregex_iterator{};
         ++at)
        pictures.insert((*at)[1]);
    for (const std::string& picture : pictures)
        zip.addFile(kRoot + picture, docs / picture);
}

}  // namespace

void writeStudentPackage(const fs::path& data, const fs::path& file) {
    zip::ZipWriter zip{file};
    addTemplate(zip, data / "student_template");
    addKind(zip, "scenes", data / "scenes", ".xml");
    addKind(zip, "assets", data / "assets", ".png");
    addHandout(zip, data / "docs");
    // An installation keeps its licence elsewhere.
    if (fs::is_regular_file(data / "LICENSE")) zip.addFile(kRoot + "LICENSE", data / "LICENSE");
    zip.finish();
}

}  // namespace ticker::package
