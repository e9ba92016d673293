#include <grader/base/JsonValue.h>
#include <grader/base/WholeFile.h>
#include <grader/corpus/Entry.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

namespace ticker::corpus {
namespace {

namespace fs = std::filesystem;
using raytracer::InputError;

constexpr const char* kExpected = "expected.json";
constexpr std::array<std::string_view, 5> kStates{"passed", "failed", "notAttempted", "blocked",
                                                  "notGraded"};
constexpr std::array<std::string_view, 3> kVerdicts{"awarded", "notAwarded", "needsReview"};
std::vector<std::string> texts(const JsonValue& array) {
    std::vector<std::string> values;
    for (const JsonValue& item : array.items())
        values.push_back(item.text());
    return values;
}

/// A string, or an array of lines.
std::string joined(const JsonValue& value) {
    if (!value.isArray()) return value.text();
    return fmt::format("{}", fmt::join(texts(value), "\n"));
}

/// The member's flag; false if the member is missing.
bool isSet(const JsonValue& value, const std::string& name) {
    return value.has(name) && value.at(name).flag();
}

/// A string or an array of strings, each one of `known`.
std::vector<std::string> choices(const JsonValue& value, std::span<const std::string_view> known) {
    std::vector<std::string> values =
        value.isArray() ? texts(value) : std::vector<std::string>{value.text()};
    for (const std::string& each : values)
        if (std::find(known.begin(), known.end(), each) == known.end())
            value.refuse(fmt::format("\"{}\" is not known", each));
    if (values.empty()) value.refuse("is empty");
    return values;
}

std::string plainName(const JsonValue& value) {
    std::string name = value.text();
    if (name.find('/') != std::string::npos) value.refuse("must be a plain name");
    return name;
}

std::string bytesOf(const JsonValue& value) {
    const std::string digits = value.text();
    if (digits.size() % 2 != 0 || digits.find_first_not_of("0123456789abcdef") != std::string::npos)
        value.refuse("is not hexadecimal");
    std::string bytes;
    for (std::size_t at = 0; at < digits.size(); at += 2)
        bytes.push_back(static_cast<char>(std::stoi(digits.substr(at, 2), nullptr, 16)));
    return bytes;
}

unsigned long countOf(const JsonValue& value) {
    const double number = value.number();
    if (number < 0.0 || number != std::floor(number)) value.refuse("must be a count");
    return static_cast<unsigned long>(number);
}

Expectation readExpectation(const JsonValue& value) {
    value.allowOnly({"state", "findings", "needsReview"});
    Expectation expect;
    expect.states = choices(value.at("state"), kStates);
    if (value.has("findings")) expect.findings = texts(value.at("findings"));
    expect.needsReview = isSet(value, "needsReview");
    return expect;
}

void readExpectations(const JsonValue& value, Entry& entry) {
    for (const auto& [name, member] : value.members())
        if (name == "verdict")
            entry.verdicts = choices(member, kVerdicts);
        else
            entry.tasks[name] = readExpectation(member);
    if (entry.tasks.empty()) value.refuse("says nothing of any task");
}

std::vector<Edit> readEdits(const JsonValue& array) {
    std::vector<Edit> edits;
    for (const JsonValue& value : array.items()) {
        value.allowOnly({"find", "replace"});
        edits.push_back({joined(value.at("find")), joined(value.at("replace"))});
        if (edits.back().find.empty()) value.refuse("has nothing to find");
    }
    return edits;
}

/// The folder of a "base": the exercise's own files, or another entry's.
fs::path folderOf(const std::string& base, const fs::path& root, const Exercise& exercise) {
    if (base == "reference") return root / exercise.reference;
    if (base == "template") return root / exercise.stubs;
    return root / exercise.corpus / base;
}

Member readMember(const JsonValue& value) {
    value.allowOnly(
        {"name", "text", "repeat", "times", "copies", "link", "hardLink", "device", "pipe"});
    Member member;
    member.name = value.at("name").text();
    if (value.has("text")) member.text = value.at("text").text();
    if (value.has("repeat")) member.text = value.at("repeat").text();
    if (value.has("times")) member.repeats = countOf(value.at("times"));
    if (value.has("copies")) member.copies = countOf(value.at("copies"));
    if (isSet(value, "device")) member.kind = Member::Kind::device;
    if (isSet(value, "pipe")) member.kind = Member::Kind::pipe;
    for (const auto& [name, kind] : {std::pair{"link", Member::Kind::symbolicLink},
                                     std::pair{"hardLink", Member::Kind::hardLink}}) {
        if (!value.has(name)) continue;
        member.kind = kind;
        member.text = value.at(name).text();
    }
    return member;
}

MadeFile readMade(const JsonValue& value) {
    value.allowOnly(
        {"file", "before", "repeat", "times", "after", "hex", "link", "pipe", "folder", "members"});
    MadeFile made{plainName(value.at("file")), {}};
    if (value.has("hex")) {
        made.contents = MadeBytes{bytesOf(value.at("hex"))};
    } else if (value.has("link")) {
        made.contents = MadeLink{value.at("link").text()};
    } else if (isSet(value, "pipe")) {
        made.contents = MadePipe{};
    } else if (isSet(value, "folder")) {
        made.contents = MadeFolder{};
    } else if (value.has("members")) {
        MadeArchive archive;
        for (const JsonValue& member : value.at("members").items())
            archive.members.push_back(readMember(member));
        made.contents = std::move(archive);
    } else {
        made.contents = MadeText{value.at("before").text(), value.at("repeat").text(),
                                 countOf(value.at("times")), value.at("after").text()};
    }
    return made;
}

Entry readEntry(const fs::path& file, const fs::path& place, const fs::path& root,
                const Exercise& exercise) {
    Entry entry;
    entry.path = file.string();
    entry.name = (file == place ? file.stem() : place.filename()).string();
    const JsonValue value = JsonValue::parse(readWhole(file), entry.path);
    value.allowOnly({"about", "alone", "folder", "base", "edits", "make", "expect"});
    entry.about = value.at("about").text();
    if (value.has("alone")) entry.alone = value.at("alone").text();
    entry.folderName = value.has("folder") ? plainName(value.at("folder")) : entry.name;
    if (value.has("base")) entry.base = folderOf(value.at("base").text(), root, exercise);
    if (value.has("edits"))
        for (const auto& [name, edits] : value.at("edits").members())
            entry.edits[name] = readEdits(edits);
    if (value.has("make"))
        for (const JsonValue& made : value.at("make").items())
            entry.made.push_back(readMade(made));
    readExpectations(value.at("expect"), entry);
    if (!entry.edits.empty() && entry.base.empty()) value.refuse("has edits of no \"base\"");
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

/// The exercise that the bases of a collection's entries belong to: the one that the collection's
/// name begins with ("tick1/mistakes"), otherwise `exercise`.
const Exercise& ownerOf(const std::string& collection, const Exercise& exercise) {
    for (const Exercise& known : knownExercises())
        if (collection.starts_with(known.name + "/")) return known;
    return exercise;
}

void addCollection(const std::string& collection, const fs::path& root, const Exercise& exercise,
                   std::vector<Entry>& entries) {
    const fs::path top = root / exercise.corpus / collection;
    const Exercise& owner = ownerOf(collection, exercise);
    if (!fs::is_directory(top)) return;
    for (const fs::directory_entry& found : fs::recursive_directory_iterator(top)) {
        const fs::path& file = found.path();
        const fs::path folder = file.parent_path();
        const bool isFolders = file.filename() == kExpected;
        if (file.extension() != ".json" || !found.is_regular_file() || folder == top) continue;
        if (!isFolders && fs::exists(folder / kExpected)) continue;
        const fs::path place = isFolders ? folder : file;
        Entry entry = readEntry(file, place, root, owner);
        entry.collection = collection;
        entry.group = place.parent_path().lexically_relative(top).string();
        if (isFolders) entry.files = filesBeside(folder);
        entries.push_back(std::move(entry));
    }
}

}  // namespace

std::vector<Entry> readEntries(const fs::path& root, const std::vector<std::string>& collections,
                               const Exercise& exercise) {
    const fs::path corpus = root / exercise.corpus;
    if (!fs::is_directory(corpus))
        throw InputError(corpus.string(), 0, "is no folder with a corpus");
    std::vector<Entry> entries;
    for (const std::string& collection : collections)
        addCollection(collection, root, exercise, entries);
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.group, a.name) < std::tie(b.group, b.name);
    });
    return entries;
}

std::vector<Entry> readCatalogue(const fs::path& root, const Exercise& exercise) {
    return readEntries(root, {"accepted", "mistakes"}, exercise);
}

}  // namespace ticker::corpus
