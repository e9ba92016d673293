#include <grader/repair/Candidates.h>

#include <grader/base/JsonValue.h>
#include <grader/base/Utf8.h>
#include <grader/base/WholeFile.h>
#include <grader/build/Program.h>
#include <grader/repair/probe/Switches.h>
#include <grader/sandbox/HelperProgram.h>

#include <raytracer/base/Error.h>

#include <fcntl.h>
#include <sys/stat.h>

#include <grader/base/FileDescriptor.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

namespace ticker::repair {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLargestReply = 8U << 20U;
constexpr const char* kProduct = "candidates.json";

const fs::path& stagedProgram() {
    static const fs::path program =
        sandbox::copyProgram("ticker-candidates", sandbox::Sandbox::makeStagingFolder());
    return program;
}

std::size_t offsetOf(const JsonValue& value, std::size_t most) {
    const double number = value.number();
    if (!(number >= 0.0 && number <= static_cast<double>(most)))
        value.expect("a place in the file");
    return static_cast<std::size_t>(number);
}

std::pair<std::size_t, std::size_t> rangeOf(const JsonValue& value, std::size_t most) {
    const auto ends = value.items();
    if (ends.size() != 2) value.expect("a beginning and an end");
    return {offsetOf(ends[0], most), offsetOf(ends[1], most)};
}

TextEdit readEdit(const JsonValue& value, std::size_t size) {
    const auto items = value.items();
    if (items.size() != 3) value.expect("a beginning, an end and a text");
    TextEdit edit{offsetOf(items[0], size), offsetOf(items[1], size), items[2].text()};
    if (edit.end < edit.begin) value.expect("an end behind the beginning");
    return edit;
}

/// The reply comes from a process that read untrusted text: anything may stand in it.
Candidates readReply(std::string text, std::size_t size) {
    const JsonValue top = JsonValue::parse(std::move(text), kProduct);
    Candidates found;
    found.program = top.at("program").text();
    found.keepsState = top.at("keepsState").flag();
    for (const JsonValue& item : top.at("atoms").items()) {
        if (found.atoms.size() == kMostEdits) break;
        Atom atom;
        atom.kind = item.at("kind").text();
        atom.function = item.at("function").text();
        atom.isApart = item.at("apart").flag();
        std::tie(atom.statementBegin, atom.statementEnd) = rangeOf(item.at("statement"), size);
        std::tie(atom.siteBegin, atom.siteEnd) = rangeOf(item.at("site"), size);
        for (const JsonValue& edit : item.at("edits").items())
            atom.edits.push_back(readEdit(edit, size));
        std::ranges::sort(atom.edits, {}, &TextEdit::begin);
        found.atoms.push_back(std::move(atom));
    }
    return found;
}

/// As ../candidates/main.cpp reads them.
std::string asArgument(const std::vector<Formula>& formulas) {
    std::string lines;
    for (const Formula& formula : formulas)
        lines += formula.type + "\t" + formula.of + "\t" + formula.text + "\n";
    return lines;
}

/// A file that a command makes, in a folder that every user can read.
struct Product {
    sandbox::JobFolder folder;
    fs::path file;
    FileDescriptor descriptor;

    explicit Product(const char* name)
        : file(folder.path() / name),
          descriptor(open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644)) {
        // fchmod, because the umask may have removed the permissions of other users.
        if (!descriptor.isOpen() || fchmod(descriptor.get(), 0644) != 0)
            throw raytracer::Error("cannot write " + file.string());
    }
};

/// The parser's command, up to the words that say what it parses. The kit is seen at its own place,
/// which the precompiled header names.
sandbox::Command parserCommand(const build::Kit& kit, const sandbox::Limits& limits,
                               const Product& product) {
    sandbox::Command command;
    command.arguments = {"/candidates"};
    command.folder = sandbox::kScratchFolder;
    command.readOnly = {
        {"/usr", "/usr"}, {kit.folder(), kit.folder()}, {stagedProgram(), "/candidates"}};
    command.wantsScratch = true;
    command.policy = sandbox::Policy::compile;
    command.limits = limits;
    command.products = {{product.file.filename().string(), product.descriptor.get()}};
    return command;
}

/// A precompiled header that was made on this machine, where the kit lies now.
struct MadeHeader {
    Product product{"Framework.pch"};

    MadeHeader(const build::Kit& kit, const sandbox::Sandbox& sandbox,
               const sandbox::Limits& limits) {
        sandbox::Command command = parserCommand(kit, limits, product);
        for (const std::string& word :
             {std::string{"--precompile"}, (kit.folder() / "pch" / "Framework.h").string(),
              product.file.filename().string(), std::string{"-xc++-header"},
              std::string{"-std=c++20"}, std::string{"-fpch-instantiate-templates"},
              "-I" + (kit.folder() / "include").string()})
            command.arguments.push_back(word);
        const sandbox::Outcome outcome = sandbox.run(command);
        if (!outcome.succeeded() || outcome.productsMissing)
            throw raytracer::Error("the framework's headers cannot be parsed: " + outcome.output);
    }
};

/// The precompiled header for the parser: the kit's own, or one that is made once for each kit
/// whose own cannot be used.
fs::path parsedHeader(const build::Kit& kit, const sandbox::Sandbox& sandbox,
                      const sandbox::Limits& limits) {
    if (fs::path own = kit.parsedHeader(); !own.empty()) return own;
    static std::mutex mutex;
    static std::map<fs::path, MadeHeader> made;
    const std::lock_guard lock{mutex};
    return made.try_emplace(kit.folder(), kit, sandbox, limits).first->second.product.file;
}

/// The file as the parser reads it. Its reply is JSON, which holds UTF-8 alone; every place stays.
std::string parsedText(std::string_view source) {
    std::string text{source};
    if (asUtf8(text) != text)
        std::ranges::replace_if(
            text, [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '?');
    return text;
}

}  // namespace

Candidates findCandidates(const build::Kit& kit, const sandbox::Sandbox& sandbox,
                          const sandbox::Limits& limits, const std::string& file,
                          std::string_view source, const Wanted& wanted) {
    const sandbox::JobFolder sources;
    sources.write(file, parsedText(source));
    const fs::path header = parsedHeader(kit, sandbox, limits);
    const Product product{kProduct};
    sandbox::Command command = parserCommand(kit, limits, product);
    const sandbox::ReadOnlyPath sourcePath{sources.path(), "/source"};
    const sandbox::ReadOnlyPath headerPath{header, "/Framework.pch"};
    command.readOnly.push_back(sourcePath);
    command.readOnly.push_back(headerPath);
    for (const std::string& word :
         {(sandbox.pathFor(sourcePath) / file).string(),
          (kit.folder() / "template" / file).string(), std::string{kProduct},
          std::string{wanted.reach == Reach::wide ? "wide" : "simple"}, wanted.leftAlone,
          asArgument(wanted.formulas), std::string{"-xc++"}, std::string{"-std=c++20"},
          "-I" + (kit.folder() / "include").string(), std::string{"-include-pch"},
          sandbox.pathFor(headerPath).string(),
          // An edit that chooses between number literals is no constant: narrowing it must not be
          // an error. Spelling proposals for edits that do not compile cost time.
          std::string{"-ferror-limit=0"}, std::string{"-Wno-c++11-narrowing"},
          std::string{"-fno-spell-checking"}, std::string{"-fshow-overloads=best"}})
        command.arguments.push_back(word);
    const sandbox::Outcome outcome = sandbox.run(command);
    if (outcome.end == sandbox::Outcome::End::failed) throw raytracer::Error(outcome.output);
    Candidates unparsed;
    unparsed.cpuMs = outcome.cpuMs;
    if (!outcome.succeeded() || outcome.productsMissing ||
        fs::file_size(product.file) > kLargestReply)
        return unparsed;
    try {
        Candidates found = readReply(readWhole(product.file), source.size());
        found.cpuMs = outcome.cpuMs;
        return found;
    } catch (const raytracer::InputError&) {
        return unparsed;
    }
}

std::optional<std::string> withEdits(std::string_view source, std::vector<TextEdit> edits) {
    std::ranges::sort(edits, {},
                      [](const TextEdit& edit) { return std::make_pair(edit.begin, edit.end); });
    std::string text;
    std::size_t at = 0;
    for (const TextEdit& edit : edits) {
        if (edit.begin < at || edit.end < edit.begin || edit.end > source.size())
            return std::nullopt;
        text += source.substr(at, edit.begin - at);
        text += edit.text;
        at = edit.end;
    }
    text += source.substr(at);
    return text;
}

}  // namespace ticker::repair
