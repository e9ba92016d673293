#include <grader/sandbox/SandboxPolicy.h>

#include <grader/base/JsonValue.h>
#include <grader/base/WholeFile.h>
#include <grader/sandbox/DefaultPolicy.h>

#include <fmt/core.h>

#include <cmath>

namespace ticker::sandbox {
namespace {

double numberIn(const JsonValue& object, const char* field, double least, double most) {
    const JsonValue value = object.at(field);
    const auto number = value.asNumber();
    if (!number || !(*number >= least && *number <= most))
        value.expect(fmt::format("a number from {} to {}", least, most));
    return *number;
}

template <typename Whole>
Whole wholeIn(const JsonValue& object, const char* field, double least, double most) {
    const double number = numberIn(object, field, least, most);
    if (std::floor(number) != number) object.at(field).expect("a whole number");
    return static_cast<Whole>(number);
}

Limits readLimits(const JsonValue& object) {
    object.allowOnly({"cpuSeconds", "wallSeconds", "addressSpaceBytes", "fileSizeBytes",
                      "stackBytes", "processes", "openFiles", "outputBytes"});
    constexpr double kMega = 1e6;
    Limits limits;
    limits.cpuSeconds = numberIn(object, "cpuSeconds", 1, 3600);
    limits.wallSeconds = numberIn(object, "wallSeconds", limits.cpuSeconds, 10'800);
    limits.addressSpaceBytes =
        wholeIn<std::uint64_t>(object, "addressSpaceBytes", 64 * kMega, 64'000 * kMega);
    limits.fileSizeBytes = wholeIn<std::uint64_t>(object, "fileSizeBytes", 4096, 16'000 * kMega);
    limits.stackBytes = wholeIn<std::uint64_t>(object, "stackBytes", 0.25 * kMega, 1000 * kMega);
    limits.processes = wholeIn<int>(object, "processes", 1, 1024);
    limits.openFiles = wholeIn<int>(object, "openFiles", 8, 1024);
    limits.outputBytes = wholeIn<std::size_t>(object, "outputBytes", 1024, 1000 * kMega);
    return limits;
}

TimeLimits readTimes(const JsonValue& object, const Limits& run) {
    object.allowOnly({"cpuSeconds", "wallSeconds"});
    return {numberIn(object, "cpuSeconds", run.cpuSeconds, 36'000),
            numberIn(object, "wallSeconds", run.wallSeconds, 108'000)};
}

UserRange readUsers(const JsonValue& object) {
    object.allowOnly({"first", "count"});
    // Uids below 1000 belong to the system; 65534 (nobody) is shared with other services.
    UserRange range;
    range.first = wholeIn<long>(object, "first", 1000, 60'000'000);
    range.count = wholeIn<int>(object, "count", 1, 4096);
    if (range.first <= 65534 && range.first + range.count > 65534)
        object.at("count").refuse("the range holds the uid 65534, which is nobody's");
    return range;
}

}  // namespace

SandboxPolicy parsePolicy(const std::string& text, const std::string& name) {
    const JsonValue top = JsonValue::parse(text, name);
    top.allowOnly({"users", "compile", "run", "submission", "decode", "match"});
    SandboxPolicy policy;
    policy.users = readUsers(top.at("users"));
    policy.compile = readLimits(top.at("compile"));
    policy.run = readLimits(top.at("run"));
    policy.submission = readTimes(top.at("submission"), policy.run);
    policy.decode = readLimits(top.at("decode"));
    policy.match = readLimits(top.at("match"));
    return policy;
}

SandboxPolicy readPolicy(const std::filesystem::path& file) {
    return parsePolicy(readWhole(file), file.string());
}

const SandboxPolicy& defaultPolicy() {
    static const SandboxPolicy policy = parsePolicy(kDefaultPolicyText, "limits.json");
    return policy;
}

}  // namespace ticker::sandbox
