#include <grader/corpus/HostileCase.h>

#include <raytracer/base/Error.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <string_view>
#include <utility>

namespace ticker::hostile {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

// One JSON object whose fields are all checked; errors name the case.
class Fields {
public:
    Fields(const Json& object, std::string file) : object_(object), file_(std::move(file)) {
        if (!object_.is_object()) fail("", "an object is expected");
    }

    [[nodiscard]] bool has(const char* name) const { return object_.contains(name); }

    [[nodiscard]] std::string text(const char* name) const {
        if (!has(name)) fail(name, "is missing");
        if (!object_.at(name).is_string()) fail(name, "must be a text");
        return object_.at(name).get<std::string>();
    }

    [[nodiscard]] unsigned long count(const char* name) const {
        if (!has(name) || !object_.at(name).is_number_unsigned()) fail(name, "must be a count");
        return object_.at(name).get<unsigned long>();
    }

    [[nodiscard]] std::vector<std::string> texts(const char* name) const {
        std::vector<std::string> result;
        for (const Json& element : array(name)) {
            if (!element.is_string()) fail(name, "must hold texts only");
            result.push_back(element.get<std::string>());
        }
        return result;
    }

    [[nodiscard]] std::vector<Fields> objects(const char* name) const {
        std::vector<Fields> result;
        for (const Json& element : array(name))
            result.emplace_back(element, file_);
        return result;
    }

    void allowOnly(std::initializer_list<std::string_view> names) const {
        for (const auto& entry : object_.items())
            if (std::find(names.begin(), names.end(), entry.key()) == names.end())
                fail(entry.key(), "is not known");
    }

    [[noreturn]] void fail(const std::string& name, const std::string& message) const {
        throw raytracer::InputError(file_, 0, name + ": " + message);
    }

private:
    [[nodiscard]] const Json& array(const char* name) const {
        if (!has(name) || !object_.at(name).is_array()) fail(name, "must be a list");
        return object_.at(name);
    }

    const Json& object_;
    std::string file_;
};

std::string bytesOf(const Fields& fields) {
    const std::string digits = fields.text("hex");
    std::string bytes;
    for (std::size_t at = 0; at + 1 < digits.size(); at += 2) {
        const auto isDigit = [&](char c) {
            return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
        };
        if (!isDigit(digits[at]) || !isDigit(digits[at + 1]))
            fields.fail("hex", "is not hexadecimal");
        bytes.push_back(static_cast<char>(std::stoi(digits.substr(at, 2), nullptr, 16)));
    }
    return bytes;
}

Member readMember(const Fields& fields) {
    fields.allowOnly(
        {"name", "text", "repeat", "times", "copies", "link", "hardLink", "device", "pipe"});
    Member member;
    member.name = fields.text("name");
    if (fields.has("text")) member.text = fields.text("text");
    if (fields.has("repeat")) member.text = fields.text("repeat");
    if (fields.has("times")) member.repeats = fields.count("times");
    if (fields.has("copies")) member.copies = fields.count("copies");
    if (fields.has("device")) member.kind = Member::Kind::device;
    if (fields.has("pipe")) member.kind = Member::Kind::pipe;
    for (const auto& [name, kind] : {std::pair{"link", Member::Kind::symbolicLink},
                                     std::pair{"hardLink", Member::Kind::hardLink}}) {
        if (!fields.has(name)) continue;
        member.kind = kind;
        member.text = fields.text(name);
    }
    return member;
}

MadeFile readMade(const Fields& fields) {
    fields.allowOnly(
        {"file", "before", "repeat", "times", "after", "hex", "link", "pipe", "folder", "members"});
    MadeFile made{fields.text("file"), {}};
    if (made.name.find('/') != std::string::npos) fields.fail("file", "must be a plain name");
    if (fields.has("hex")) {
        made.contents = MadeBytes{bytesOf(fields)};
    } else if (fields.has("link")) {
        made.contents = MadeLink{fields.text("link")};
    } else if (fields.has("pipe")) {
        made.contents = MadePipe{};
    } else if (fields.has("folder")) {
        made.contents = MadeFolder{};
    } else if (fields.has("members")) {
        MadeArchive archive;
        for (const Fields& member : fields.objects("members"))
            archive.members.push_back(readMember(member));
        made.contents = std::move(archive);
    } else {
        made.contents = MadeText{fields.text("before"), fields.text("repeat"),
                                 fields.count("times"), fields.text("after")};
    }
    return made;
}

std::vector<std::string> choices(const Fields& fields, const char* name,
                                 std::initializer_list<std::string_view> known) {
    std::vector<std::string> values = fields.texts(name);
    if (values.empty()) fields.fail(name, "is empty");
    for (const std::string& value : values)
        if (std::find(known.begin(), known.end(), value) == known.end())
            fields.fail(name, "does not know \"" + value + "\"");
    return values;
}

HostileCase readCase(const fs::path& folder) {
    const fs::path file = folder / "expected.json";
    std::ifstream stream{file, std::ios::binary};
    const Json json = Json::parse(stream, nullptr, false);
    if (json.is_discarded())
        throw raytracer::InputError(file.string(), 0, "is missing, or not JSON");
    const Fields fields{json, file.string()};
    fields.allowOnly({"about", "task", "states", "findings", "verdicts", "make", "folder"});
    HostileCase result;
    result.name = folder.filename().string();
    result.handedInAs = fields.has("folder") ? fields.text("folder") : result.name;
    if (result.handedInAs.find('/') != std::string::npos)
        fields.fail("folder", "must be a plain name");
    result.folder = folder;
    result.about = fields.text("about");
    result.task = fields.text("task");
    result.states = choices(fields, "states", {"passed", "failed", "notAttempted", "blocked"});
    result.findings = fields.texts("findings");
    result.verdicts = choices(fields, "verdicts", {"awarded", "notAwarded", "needsReview"});
    if (fields.has("make"))
        for (const Fields& made : fields.objects("make"))
            result.made.push_back(readMade(made));
    return result;
}

}  // namespace

std::vector<HostileCase> listHostileCases(const fs::path& folder) {
    std::vector<fs::path> folders;
    if (!fs::is_directory(folder))
        throw raytracer::InputError(folder.string(), 0, "is no folder of hostile submissions");
    for (const fs::directory_entry& entry : fs::directory_iterator{folder})
        if (entry.is_directory()) folders.push_back(entry.path());
    std::sort(folders.begin(), folders.end());
    std::vector<HostileCase> cases;
    for (const fs::path& each : folders)
        cases.push_back(readCase(each));
    return cases;
}

}  // namespace ticker::hostile
