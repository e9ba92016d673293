#include <grader/package/Bundle.h>

#include <grader/base/Digest.h>
#include <grader/base/ShellQuoted.h>
#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <link.h>

#include <string>
#include <string_view>
#include <system_error>

namespace ticker::package {
namespace {

namespace fs = std::filesystem;

/// The shared libraries of this process, including the dynamic loader: all that the program needs
/// on another machine.
std::vector<fs::path> sharedLibraries() {
    std::vector<fs::path> files;
    dl_iterate_phdr(
        [](dl_phdr_info* object, std::size_t /*size*/, void* list) {
            const fs::path file{object->dlpi_name};
            // Left out: the program itself, which has an empty name, and the vDSO, which has no
            // file.
            if (file.is_absolute()) static_cast<std::vector<fs::path>*>(list)->push_back(file);
            return 0;
        },
        &files);
    return files;
}

std::string replaced(std::string text, std::string_view mark, std::string_view value) {
    for (std::size_t at = text.find(mark); at != std::string::npos;
         at = text.find(mark, at + value.size()))
        text.replace(at, mark.size(), value);
    return text;
}

bool isLoader(const fs::path& library) {
    return library.filename().string().starts_with("ld-linux");
}

// The kernel may report the loader as the running program instead of ticker. Both are in the same
// folder, so that ticker finds its kit and data in either case.
void addProgram(zip::ZipWriter& zip, const Parts& parts) {
    zip.add("ticker/bin/ticker", integration(parts, "bundle/ticker"), true);
    zip.addFile("ticker/bin/ticker.program", parts.program);
    for (const fs::path& library : sharedLibraries())
        if (isLoader(library))
            zip.addFile("ticker/bin/loader", library);
        else
            zip.addFile("ticker/lib/shared/" + library.filename().string(), library);
    zip.addFile("ticker/libexec/ticker/ticker-jail", parts.helper);
    zip.addFile("ticker/libexec/ticker/ticker-decode", parts.decoder);
}

// The precompiled header is left out: only the compiler version that made it can read it.
void addKit(zip::ZipWriter& zip, const Parts& parts) {
    const std::string kit = "ticker/lib/ticker/kit/" + parts.exercise.name + "/";
    for (const char* folder : {"include", "lib", "template"})
        zip.addFolder(kit + folder, parts.kit / folder);
    zip.addFile(kit + "kit.json", parts.kit / "kit.json");
    zip.addFile(kit + "pch/Framework.h", parts.kit / "pch" / "Framework.h");
}

void addData(zip::ZipWriter& zip, const Parts& parts) {
    const std::string share = "ticker/share/ticker/";
    zip.addFolder(share + "scenes", parts.data / "scenes");
    for (const char* map : {"bumpmap.png", "bumpmap-test.png"})
        zip.addFile(share + "assets/" + map, parts.data / "assets" / map);
    zip.addFile(share + parts.exercise.rubric, parts.rubric);
    zip.addFile(share + "grader/report/student-view.json", parts.studentView);
}

std::string quoted(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + shellQuoted(word);
    return text;
}

/// Returns "12" for "/usr/bin/x86_64-linux-gnu-g++-12": Debian's package names contain it.
std::string majorVersion(const std::string& compiler) {
    std::error_code error;
    const std::string real = fs::canonical(compiler, error).filename().string();
    if (error)
        throw raytracer::InputError(compiler, 0,
                                    "the compiler of the kit cannot be found: " + error.message() +
                                        "; install it, or build again with another");
    const std::size_t dash = real.rfind('-');
    const std::string version = dash == std::string::npos ? "" : real.substr(dash + 1);
    if (version.empty() || version.find_first_not_of("0123456789") != std::string::npos)
        throw raytracer::Error("no version in the compiler's name: " + real);
    return version;
}

std::string prepareScript(const Parts& parts) {
    std::string text = integration(parts, "bundle/prepare.sh");
    text = replaced(std::move(text), "@COMPILER@", parts.compiler);
    text = replaced(std::move(text), "@MAJOR@", majorVersion(parts.compiler));
    text = replaced(std::move(text), "@COMPILE@", quoted(parts.compileFlags));
    return replaced(std::move(text), "@LINK@", quoted(parts.linkFlags));
}

/// The sentence about the files to hand in. Of several options, the files of one are enough.
std::string handInWords(const Exercise& exercise) {
    std::vector<std::string> files;
    for (const std::string& file : exercise.files())
        files.push_back("<code>" + file + "</code>");
    std::string text = "Hand in " + enumerated(files, exercise.options.size() > 1 ? "or" : "and");
    if (exercise.hasScreenshot())
        text += ", and <code>screenshot.png</code> from the scene that the handout names";
    return text + ".";
}

/// A course may have a question for each exercise, and PrairieLearn tells them apart by this.
std::string questionId(const Exercise& exercise) {
    std::string id = Digest{}.add("question").add(exercise.name).text();
    for (const std::size_t at : {20U, 16U, 12U, 8U})
        id.insert(at, "-");
    return id;
}

}  // namespace

std::string integration(const Parts& parts, const std::string& name) {
    std::string text = readWhole(parts.data / "grader" / "integrations" / name);
    text = replaced(std::move(text), "@EXERCISE@", parts.exercise.name);
    text = replaced(std::move(text), "@TITLE@", parts.exercise.title);
    text = replaced(std::move(text), "@UUID@", questionId(parts.exercise));
    text = replaced(std::move(text), "@HANDIN@", handInWords(parts.exercise));
    return replaced(std::move(text), "@PARTS@",
                    fmt::format("{}", fmt::join(parts.exercise.parts(), ", ")));
}

void addBundle(zip::ZipWriter& zip, const Parts& parts) {
    const std::string script = prepareScript(parts);  // first: the rest takes seconds
    addProgram(zip, parts);
    addKit(zip, parts);
    addData(zip, parts);
    zip.add("ticker/prepare.sh", script, true);
}

}  // namespace ticker::package
