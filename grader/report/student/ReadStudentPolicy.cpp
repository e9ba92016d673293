#include <grader/base/JsonValue.h>
#include <grader/base/WholeFile.h>
#include <grader/report/student/StudentView.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ticker::report {
namespace {

using raytracer::InputError;

/// The boolean members.
const std::map<std::string, bool StudentPolicy::*>& switches() {
    static const std::map<std::string, bool StudentPolicy::*> kSwitches{
        {"hints", &StudentPolicy::hints},
        {"compilerOutput", &StudentPolicy::compilerOutput},
        {"warnings", &StudentPolicy::warnings},
        {"notes", &StudentPolicy::notes},
        {"ownPictures", &StudentPolicy::ownPictures},
        {"rays", &StudentPolicy::rays}};
    return kSwitches;
}

constexpr const char* kRepairs = "repairs";

StudentPolicy::Repairs repairsOf(const JsonValue& value) {
    const std::string word = value.text();
    if (word == "off") return StudentPolicy::Repairs::off;
    if (word == "line") return StudentPolicy::Repairs::line;
    if (word == "line and hint") return StudentPolicy::Repairs::lineAndHint;
    value.expect("off, line, or line and hint");
}

std::string unknownMember(const std::string& name) {
    std::vector<std::string_view> known{"evidence", kRepairs};
    for (const auto& [each, unused] : switches())
        known.push_back(each);
    return "expected no member of this name" + raytracer::knownNamesHint(name, known);
}

void takeMember(const std::string& name, const JsonValue& value, StudentPolicy& policy) {
    if (const auto known = switches().find(name); known != switches().end()) {
        policy.*known->second = value.flag();
        return;
    }
    if (name == kRepairs) {
        policy.repairs = repairsOf(value);
        return;
    }
    if (name != "evidence") value.refuse(unknownMember(name));
    if (!value.isArray()) value.expect("an array of strings");
    for (const JsonValue& key : value.items()) {
        if (!key.asText()) value.expect("an array of strings");
        policy.evidence.push_back(key.text());
    }
}

}  // namespace

StudentPolicy readStudentPolicy(const std::filesystem::path& path) {
    const JsonValue document =
        JsonValue::parse(readWhole(path, "cannot be read; expected a student view"), path.string());
    if (!document.isObject()) throw InputError(path.string(), 1, "expected an object");
    // A missing member must not default to "show".
    for (const auto& [name, unused] : switches())
        if (name != "rays" && !document.has(name))  // which is off where it is missing
            throw InputError(path.string(), 1, fmt::format("expected a member \"{}\"", name));
    StudentPolicy policy;
    const auto members = document.members();
    for (const auto& [name, value] : std::map(members.begin(), members.end()))
        takeMember(name, value, policy);
    return policy;
}

}  // namespace ticker::report
