#include <grader/base/MakeFolder.h>
#include <grader/base/WholeFile.h>
#include <grader/build/Kit.h>
#include <grader/cli/Home.h>
#include <grader/cli/verbs/Verb.h>
#include <grader/corpus/Entry.h>
#include <grader/lab/LabVerbs.h>
#include <grader/lab/similar/Evaluate.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

/// Names that a disguise keeps: keywords, and all words of the kit's headers, of the template and
/// of the reference, which include the names that these use of the standard library.
std::set<std::string> namesThatStay(const similar::Originals& originals, const fs::path& data) {
    std::set<std::string> names{"std",  "auto", "const",  "double", "int",   "float",
                                "for",  "if",   "else",   "while",  "do",    "return",
                                "bool", "void", "struct", "class",  "using", "static_cast"};
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator{data / "student_template" / "framework" / "include"})
        if (entry.is_regular_file()) names.merge(similar::wordsOf(readWhole(entry.path())));
    for (const std::string& text : originals.known)
        names.merge(similar::wordsOf(text));
    return names;
}

similar::Originals originalsOf(const std::string& file, const Exercise& exercise,
                               const fs::path& data) {
    similar::Originals originals;
    originals.file = file;
    originals.known = {build::Kit::besideProgram(exercise).templateSource(file),
                       readWhole(data / exercise.reference / file)};
    originals.names = namesThatStay(originals, data);
    for (const corpus::Entry& entry : corpus::readEntries(data, {"unseen", "samples"}, exercise)) {
        if (!entry.base.empty()) continue;
        const auto texts = corpus::textsOf(entry);
        if (const auto text = texts.find(file); text != texts.end())
            originals.files.push_back({entry.name, text->second});
    }
    return originals;
}

/// Writes the originals and their disguised copies as files, for other tools.
void writeCopies(const similar::Originals& originals, const fs::path& folder) {
    for (std::size_t i = 0; i < originals.files.size(); ++i) {
        const fs::path target = folder / originals.file / originals.files[i].submission;
        makeFolder(target);
        std::ofstream{target / "original.cpp"} << originals.files[i].text;
        for (const similar::Disguise disguise : similar::kDisguises)
            std::ofstream{target / (std::string{similar::toString(disguise)} + ".cpp")}
                << similar::copyOf(originals, i, disguise);
    }
}

raytracer::ExitCode evaluateSimilarity(const std::string& write) {
    const fs::path data = Home::find().data;
    const Exercise& exercise = defaultExercise();
    std::vector<similar::Row> rows;
    for (const std::string& file : exercise.files()) {
        const similar::Originals originals = originalsOf(file, exercise, data);
        if (!write.empty()) writeCopies(originals, write);
        for (similar::Row& row : similar::evaluate(originals, sandbox::Sandbox::best()))
            rows.push_back(std::move(row));
    }
    fmt::print("{}", similar::tableOf(rows));
    return raytracer::ExitCode::success;
}

}  // namespace

Run addSimilarity(CLI::App& app, const GlobalOptions& /*global*/) {
    auto write = std::make_shared<std::string>();
    CLI::App* verb = app.add_subcommand(
        "similarity", "How often pairs that `ticker similar` lists are copies, by the corpus");
    verb->add_option("--write", *write, "Folder for the originals and their disguised copies");
    return [write] { return evaluateSimilarity(*write); };
}

}  // namespace ticker::cli
