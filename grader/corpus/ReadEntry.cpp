#include <grader/base/JsonLines.h>
#include <grader/base/WholeFile.h>
#include <grader/corpus/Entry.h>
#include <grader/corpus/Members.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace ticker::corpus {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using raytracer::InputError;

constexpr const char* kExpected = "expected.json";
constexpr std::array<std::string_view, 5> kStates{"passed", "failed", "notAttempted", "blocked",
                                                  "notGraded"};
constexpr std::array<std::string_view, 3> kVerdicts{"awarded", "notAwarded", "needsReview"};

json parse(const std::string& path) {
    const std::string text = readWhole(path);
    try {
        return json::parse(text);
    } catch (const json::parse_error& error) {
        throw InputError(path, lineOfByte(text, error.byte), "is not JSON");
    }
}

Expectation readExpectation(const json& object, const std::string& path, const std::string& task) {
    Members members(object, path, "\"expect\" of " + task);
    Expectation expect;
    expect.states = members.choices("state", kStates);
    if (members.has("findings")) expect.findings = members.strings("findings");
    expect.needsReview = members.flag("needsReview");
    members.finish();
    return expect;
}

void readExpectations(const json& object, Entry& entry) {
    Members members(object, entry.path, "\"expect\"");
    for (const auto& [name, value] : object.items())
        if (name == "verdict")
            entry.verdicts = members.choices("verdict", kVerdicts);
        else
            entry.tasks[name] = readExpectation(value, entry.path, name);
    if (entry.tasks.empty()) members.fail("says nothing of any task");
}

std::vector<Edit> readEdits(const json& array, const std::string& path) {
    if (!array.is_array()) throw InputError(path, 0, "\"edits\" of a file must be an array");
    std::vector<Edit> edits;
    for (const json& object : array) {
        Members members(object, path, "\"edits\"[" + std::to_string(edits.size()) + "]");
        Edit edit{members.text("find"), members.text("replace")};
        members.finish();
        if (edit.find.empty()) members.fail("has nothing to find");
        edits.push_back(std::move(edit));
    }
    return edits;
}

/// @param exercise  The first folder of a collection that belongs to another exercise than the
///                  default one; or empty.
fs::path folderOf(const std::string& base, const fs::path& root, const fs::path& exercise) {
    if (base == "reference") return root / "reference_solution" / exercise / "exercise";
    if (base == "template") return root / "student_template" / exercise / "exercise";
    return root / "grader/corpus" / base;
}

Member readMember(Members members) {
    Member member;
    member.name = members.string("name");
    if (members.has("text")) member.text = members.string("text");
    if (members.has("repeat")) member.text = members.string("repeat");
    if (members.has("times")) member.repeats = members.count("times");
    if (members.has("copies")) member.copies = members.count("copies");
    if (members.flag("device")) member.kind = Member::Kind::device;
    if (members.flag("pipe")) member.kind = Member::Kind::pipe;
    for (const auto& [name, kind] : {std::pair{"link", Member::Kind::symbolicLink},
                                     std::pair{"hardLink", Member::Kind::hardLink}}) {
        if (!members.has(name)) continue;
        member.kind = kind;
        member.text = members.string(name);
    }
    members.finish();
    return member;
}

decltype(MadeFile::contents) readContents(Members& members, const std::string& path) {
    if (members.has("hex")) return MadeBytes{members.bytes("hex")};
    if (members.has("link")) return MadeLink{members.string("link")};
    if (members.flag("pipe")) return MadePipe{};
    if (members.flag("folder")) return MadeFolder{};
    if (!members.has("members"))
        return MadeText{members.string("before"), members.string("repeat"), members.count("times"),
                        members.string("after")};
    MadeArchive archive;
    for (const json& member : members.array("members"))
        archive.members.push_back(readMember({member, path, "a member of an archive"}));
    return archive;
}

void readMade(const json& array, Entry& entry) {
    for (const json& object : array) {
        Members members(object, entry.path, "\"make\"[" + std::to_string(entry.made.size()) + "]");
        MadeFile made{members.plainName("file"), {}};
        made.contents = readContents(members, entry.path);
        members.finish();
        entry.made.push_back(std::move(made));
    }
}

Entry readEntry(const fs::path& file, const fs::path& place, const fs::path& root,
                const fs::path& exercise) {
    Entry entry;
    entry.path = file.string();
    entry.name = (file == place ? file.stem() : place.filename()).string();
    const json document = parse(entry.path);
    Members members(document, entry.path, "the entry");
    entry.about = members.string("about");
    entry.folderName = members.has("folder") ? members.plainName("folder") : entry.name;
    if (members.has("base")) entry.base = folderOf(members.string("base"), root, exercise);
    if (members.has("edits"))
        for (const auto& [name, edits] : members.required("edits").items())
            entry.edits[name] = readEdits(edits, entry.path);
    if (members.has("make")) readMade(members.array("make"), entry);
    readExpectations(members.required("expect"), entry);
    members.finish();
    if (!entry.edits.empty() && entry.base.empty()) members.fail("has edits of no \"base\"");
    return entry;
}

std::vector<fs::path> filesBeside(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& file : fs::directory_iterator{folder})
        if (file.is_regular_file() && file.path().filename() != kExpected)
            files.push_back(file.path());
    std::sort(files.begin(), files.end());
    return files;
}

void addCollection(const std::string& collection, const fs::path& root,
                   std::vector<Entry>& entries) {
    const fs::path top = root / "grader/corpus" / collection;
    if (!fs::is_directory(top)) return;
    for (const fs::directory_entry& found : fs::recursive_directory_iterator(top)) {
        const fs::path& file = found.path();
        const fs::path folder = file.parent_path();
        const bool isFolders = file.filename() == kExpected;
        if (file.extension() != ".json" || !found.is_regular_file() || folder == top) continue;
        if (!isFolders && fs::exists(folder / kExpected)) continue;
        const fs::path place = isFolders ? folder : file;
        Entry entry = readEntry(file, place, root, fs::path{collection}.parent_path());
        entry.collection = collection;
        entry.group = place.parent_path().lexically_relative(top).string();
        if (isFolders) entry.files = filesBeside(folder);
        entries.push_back(std::move(entry));
    }
}

}  // namespace

std::vector<Entry> readEntries(const fs::path& root, const std::vector<std::string>& collections) {
    if (!fs::is_directory(root / "grader/corpus"))
        throw InputError((root / "grader/corpus").string(), 0, "is no folder with a corpus");
    std::vector<Entry> entries;
    for (const std::string& collection : collections)
        addCollection(collection, root, entries);
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.group, a.name) < std::tie(b.group, b.name);
    });
    return entries;
}

std::vector<Entry> readCatalogue(const fs::path& root) {
    return readEntries(root, {"accepted", "mistakes"});
}

}  // namespace ticker::corpus
