#include <grader/base/JsonLines.h>
#include <grader/base/WholeFile.h>
#include <grader/report/StudentView.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ticker::report {
namespace {

using Json = nlohmann::json;
using raytracer::InputError;

/// The members that are true or false.
const std::map<std::string, bool StudentPolicy::*>& switches() {
    static const std::map<std::string, bool StudentPolicy::*> kSwitches{
        {"hints", &StudentPolicy::hints},
        {"compilerOutput", &StudentPolicy::compilerOutput},
        {"warnings", &StudentPolicy::warnings},
        {"notes", &StudentPolicy::notes},
        {"ownPictures", &StudentPolicy::ownPictures}};
    return kSwitches;
}

struct File {
    std::string name;
    std::string text;

    [[noreturn]] void refuse(const std::string& member, const std::string& why) const {
        throw InputError(name, jsonLineOf(text, "/" + member), fmt::format("/{}: {}", member, why));
    }
};

std::string unknownMember(const std::string& name) {
    std::vector<std::string_view> known{"evidence"};
    for (const auto& [each, unused] : switches())
        known.push_back(each);
    return "expected no member of this name" + raytracer::knownNamesHint(name, known);
}

void takeMember(const File& file, const std::string& name, const Json& value,
                StudentPolicy& policy) {
    if (const auto known = switches().find(name); known != switches().end()) {
        if (!value.is_boolean()) file.refuse(name, "expected true or false");
        policy.*known->second = value.get<bool>();
        return;
    }
    if (name != "evidence") file.refuse(name, unknownMember(name));
    if (!value.is_array()) file.refuse(name, "expected an array of strings");
    for (const Json& key : value) {
        if (!key.is_string()) file.refuse(name, "expected an array of strings");
        policy.evidence.push_back(key.get<std::string>());
    }
}

}  // namespace

StudentPolicy readStudentPolicy(const std::filesystem::path& path) {
    const File file{path.string(), readWhole(path, "cannot be read; expected a student view")};
    Json document;
    try {
        document = Json::parse(file.text);
    } catch (const Json::parse_error& error) {
        throw InputError(file.name, lineOfByte(file.text, error.byte),
                         fmt::format("not JSON: {}", error.what()));
    }
    if (!document.is_object()) throw InputError(file.name, 1, "expected an object");
    // What a course forgot to say must not fall open.
    for (const auto& [name, unused] : switches())
        if (!document.contains(name))
            throw InputError(file.name, 1, fmt::format("expected a member \"{}\"", name));
    StudentPolicy policy;
    for (const auto& [name, value] : document.items())
        takeMember(file, name, value, policy);
    return policy;
}

}  // namespace ticker::report
