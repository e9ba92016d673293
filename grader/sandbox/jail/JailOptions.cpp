#include <grader/sandbox/jail/JailOptions.h>

#include <charconv>
#include <cstddef>
#include <optional>

namespace ticker::jail {
namespace {

template <typename T>
std::optional<T> number(std::string_view text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

template <typename T>
bool store(std::string_view text, T& into) {
    const std::optional<T> value = number<T>(text);
    if (value) into = *value;
    return value.has_value();
}

std::string_view toString(Filter filter) {
    switch (filter) {
        case Filter::compile:
            return "compile";
        case Filter::run:
            return "run";
        case Filter::none:
            break;
    }
    return "none";
}

bool storeFilter(std::string_view text, Filter& into) {
    for (const Filter filter : {Filter::none, Filter::compile, Filter::run}) {
        if (text != toString(filter)) continue;
        into = filter;
        return true;
    }
    return false;
}

bool storeProduct(std::string_view text, std::vector<Product>& into) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return false;
    const std::optional<int> descriptor = number<int>(text.substr(0, colon));
    if (!descriptor) return false;
    into.push_back({std::string{text.substr(colon + 1)}, *descriptor});
    return true;
}

bool storeDescriptor(std::string_view text, std::vector<int>& into) {
    const std::optional<int> value = number<int>(text);
    if (value) into.push_back(*value);
    return value.has_value();
}

bool storeText(std::string_view text, std::string& into) {
    into = text;
    return true;
}

bool storeFlag(std::string_view text, bool& into) {
    into = text == "1";
    return into || text == "0";
}

bool understand(std::string_view key, std::string_view value, Options& o) {
    if (key == "--user") return store(value, o.user);
    if (key == "--parent") return store(value, o.parent);
    if (key == "--reports") return storeFlag(value, o.reports);
    if (key == "--landlock") return storeFlag(value, o.landlock);
    if (key == "--filter") return storeFilter(value, o.filter);
    if (key == "--cpu") return store(value, o.cpuSeconds);
    if (key == "--address-space") return store(value, o.addressSpaceBytes);
    if (key == "--file-size") return store(value, o.fileSizeBytes);
    if (key == "--stack") return store(value, o.stackBytes);
    if (key == "--processes") return store(value, o.processes);
    if (key == "--open-files") return store(value, o.openFiles);
    if (key == "--folder") return storeText(value, o.folder);
    if (key == "--scratch") return storeText(value, o.scratch);
    if (key == "--read-only") return o.readOnly.emplace_back(value), true;
    if (key == "--descriptor") return storeDescriptor(value, o.descriptors);
    if (key == "--product") return storeProduct(value, o.products);
    return false;
}

}  // namespace

std::vector<std::string> toArguments(const Options& options) {
    std::vector<std::string> words;
    const auto add = [&](const char* key, std::string value) {
        words.emplace_back(key);
        words.push_back(std::move(value));
    };
    const auto addNumber = [&](const char* key, auto value, auto absent) {
        if (value != absent) add(key, std::to_string(value));
    };
    addNumber("--user", options.user, -1L);
    addNumber("--parent", options.parent, -1L);
    addNumber("--reports", options.reports ? 1 : 0, 0);
    addNumber("--landlock", options.landlock ? 1 : 0, 0);
    add("--filter", std::string{toString(options.filter)});
    addNumber("--cpu", options.cpuSeconds, std::uint64_t{0});
    addNumber("--address-space", options.addressSpaceBytes, std::uint64_t{0});
    addNumber("--file-size", options.fileSizeBytes, std::uint64_t{0});
    addNumber("--stack", options.stackBytes, std::uint64_t{0});
    addNumber("--processes", options.processes, std::uint64_t{0});
    addNumber("--open-files", options.openFiles, std::uint64_t{0});
    if (!options.folder.empty()) add("--folder", options.folder);
    if (!options.scratch.empty()) add("--scratch", options.scratch);
    for (const std::string& path : options.readOnly)
        add("--read-only", path);
    for (const int descriptor : options.descriptors)
        add("--descriptor", std::to_string(descriptor));
    for (const Product& product : options.products)
        add("--product", std::to_string(product.descriptor) + ":" + product.name);
    words.emplace_back("--");
    words.insert(words.end(), options.command.begin(), options.command.end());
    return words;
}

ParsedOptions parseOptions(const std::vector<std::string_view>& arguments) {
    ParsedOptions parsed;
    std::size_t at = 0;
    while (at < arguments.size() && arguments[at] != "--") {
        const bool understood = at + 1 < arguments.size() &&
                                understand(arguments[at], arguments[at + 1], parsed.options);
        if (!understood) {
            parsed.error = arguments[at];
            return parsed;
        }
        at += 2;
    }
    for (++at; at < arguments.size(); ++at)
        parsed.options.command.emplace_back(arguments[at]);
    if (parsed.options.command.empty()) parsed.error = "no command";
    return parsed;
}

}  // namespace ticker::jail
