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

// Listed one by one, so that other things in the folder, such as a build, are left out.
constexpr std::array kFolders{".devcontainer", ".vscode", "cmake", "framework", "tests"};
constexpr std::array kFiles{".clangd", "CMakeLists.txt", "CMakePresets.json", "README.md",
                            "check",   "check.cmd",      "check.json",        "vcpkg.json"};

/// A student's package on its way.
class Package {
public:
    Package(const fs::path& data, const Exercise& exercise, const fs::path& file)
        : data_(data), exercise_(exercise), root_(exercise.name + "/"), zip_(file) {}

    void write() {
        addTemplate();
        addKind("scenes", ".xml");
        addKind("assets", ".png");
        addHandout();
        // An installation keeps its licence elsewhere.
        if (fs::is_regular_file(data_ / "LICENSE"))
            zip_.addFile(root_ + "LICENSE", data_ / "LICENSE");
        zip_.finish();
    }

private:
    void addTemplate() {
        const fs::path folder = data_ / "student_template";
        for (const char* name : kFolders)
            zip_.addFolder(root_ + name, folder / name);
        zip_.addFolder(root_ + "exercise", data_ / exercise_.stubs);
        for (const char* name : kFiles)
            zip_.addFile(root_ + name, folder / name);
    }

    /// Adds the files of one kind directly in a folder, without subfolders: assets/references/ is
    /// not handed out.
    void addKind(const std::string& name, const std::string& extension) {
        std::set<fs::path> files;
        for (const fs::directory_entry& entry : fs::directory_iterator{data_ / name})
            if (entry.is_regular_file() && entry.path().extension() == extension)
                files.insert(entry.path());
        for (const fs::path& found : files)
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
