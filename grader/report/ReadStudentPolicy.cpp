#include <grader/report/StudentView.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <map>
#include <string>
#include <utility>

namespace ticker::report {
namespace {

using nlohmann::json;
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

void takeMember(const std::string& file, const std::string& name, const json& value,
                StudentPolicy& policy) {
    if (const auto known = switches().find(name); known != switches().end()) {
        if (!value.is_boolean())
            throw InputError(file, 0, fmt::format("/{}: expected true or false", name));
        policy.*known->second = value.get<bool>();
        return;
    }
    if (name != "evidence")
        throw InputError(file, 0, fmt::format("/{}: expected no member of this name", name));
    if (!value.is_array()) throw InputError(file, 0, "/evidence: expected an array of strings");
    for (const json& key : value) {
        if (!key.is_string()) throw InputError(file, 0, "/evidence: expected an array of strings");
        policy.evidence.push_back(key.get<std::string>());
    }
}

}  // namespace

StudentPolicy readStudentPolicy(const std::filesystem::path& file) {
    std::ifstream stream{file};
    if (!stream) throw InputError(file.string(), 0, "cannot be read; expected a student view");
    json document;
    try {
        document = json::parse(stream);
    } catch (const json::exception& error) {
        throw InputError(file.string(), 0, fmt::format("not JSON: {}", error.what()));
    }
    if (!document.is_object()) throw InputError(file.string(), 0, "expected an object");
    // What a course forgot to say must not fall open.
    for (const auto& [name, unused] : switches())
        if (!document.contains(name))
            throw InputError(file.string(), 0, fmt::format("expected a member \"{}\"", name));
    StudentPolicy policy;
    for (const auto& [name, value] : document.items())
        takeMember(file.string(), name, value, policy);
    return policy;
}

}  // namespace ticker::report
