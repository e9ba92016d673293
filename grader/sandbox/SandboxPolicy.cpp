#include <grader/sandbox/SandboxPolicy.h>

#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace ticker::sandbox {

// Made from limits.json by CMake.
extern const char* const kDefaultPolicyText;

namespace {

using Json = nlohmann::json;
using raytracer::InputError;

class Reader {
public:
    Reader(const Json& object, std::string file, std::string where)
        : object_(object), file_(std::move(file)), where_(std::move(where)) {
        if (!object_.is_object()) fail("", "an object is expected");
    }

    [[nodiscard]] double number(const char* field, double least, double most) const {
        const auto found = object_.find(field);
        if (found == object_.end()) fail(field, "is missing");
        if (!found->is_number()) fail(field, "must be a number, but is " + found->dump());
        const double value = found->get<double>();
        if (!(value >= least && value <= most))
            fail(field, fmt::format("must lie in [{}, {}], but is {}", least, most, value));
        return value;
    }

    template <typename Whole>
    [[nodiscard]] Whole whole(const char* field, double least, double most) const {
        const double value = number(field, least, most);
        if (!object_.at(field).is_number_integer()) fail(field, "must be a whole number");
        return static_cast<Whole>(value);
    }

    [[nodiscard]] Reader part(const char* field) const {
        const auto found = object_.find(field);
        if (found == object_.end()) fail(field, "is missing");
        return {*found, file_, where_ + field + "."};
    }

    void allowOnly(std::initializer_list<std::string_view> fields) const {
        for (const auto& entry : object_.items())
            if (std::find(fields.begin(), fields.end(), entry.key()) == fields.end())
                fail(entry.key(), "is not known");
    }

    [[noreturn]] void fail(const std::string& field, const std::string& message) const {
        throw InputError(file_, 0, where_ + field + ": " + message);
    }

private:
    const Json& object_;
    std::string file_;
    std::string where_;
};

Limits readLimits(const Reader& reader) {
    reader.allowOnly({"cpuSeconds", "wallSeconds", "addressSpaceBytes", "fileSizeBytes",
                      "stackBytes", "processes", "openFiles", "outputBytes"});
    constexpr double kMega = 1e6;
    Limits limits;
    limits.cpuSeconds = reader.number("cpuSeconds", 1, 3600);
    limits.wallSeconds = reader.number("wallSeconds", limits.cpuSeconds, 10'800);
    limits.addressSpaceBytes =
        reader.whole<std::uint64_t>("addressSpaceBytes", 64 * kMega, 64'000 * kMega);
    limits.fileSizeBytes = reader.whole<std::uint64_t>("fileSizeBytes", 4096, 16'000 * kMega);
    limits.stackBytes = reader.whole<std::uint64_t>("stackBytes", 0.25 * kMega, 1000 * kMega);
    limits.processes = reader.whole<int>("processes", 1, 1024);
    limits.openFiles = reader.whole<int>("openFiles", 8, 1024);
    limits.outputBytes = reader.whole<std::size_t>("outputBytes", 1024, 64 * kMega);
    return limits;
}

TimeLimits readTimes(const Reader& reader, const Limits& run) {
    reader.allowOnly({"cpuSeconds", "wallSeconds"});
    return {reader.number("cpuSeconds", run.cpuSeconds, 36'000),
            reader.number("wallSeconds", run.wallSeconds, 108'000)};
}

UserRange readUsers(const Reader& reader) {
    reader.allowOnly({"first", "count"});
    // Uids below 1000 belong to the system; 65534 (nobody) is shared with other services.
    UserRange range;
    range.first = reader.whole<long>("first", 1000, 60'000'000);
    range.count = reader.whole<int>("count", 1, 4096);
    if (range.first <= 65534 && range.first + range.count > 65534)
        reader.fail("count", "the range holds the uid 65534, which is nobody's");
    return range;
}

}  // namespace

SandboxPolicy parsePolicy(const std::string& text, const std::string& name) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) throw InputError(name, 0, "is not JSON");
    const Reader reader{json, name, ""};
    reader.allowOnly({"users", "compile", "run", "submission", "decode"});
    SandboxPolicy policy;
    policy.users = readUsers(reader.part("users"));
    policy.compile = readLimits(reader.part("compile"));
    policy.run = readLimits(reader.part("run"));
    policy.submission = readTimes(reader.part("submission"), policy.run);
    policy.decode = readLimits(reader.part("decode"));
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
