// golden_class ROOT CLASS [EVERY]: writes samples, unseen solutions, and a third of the catalogue
// and of the hostile cases into CLASS, one folder each. EVERY 30 keeps one entry of thirty.
#include <grader/corpus/Entry.h>
#include <grader/result/GeneralFindings.h>

#include <raytracer/base/Error.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace ticker;

/// A number that depends only on the name, so that new entries do not change the selection of
/// others.
unsigned long sumOf(std::string_view name) {
    return std::accumulate(name.begin(), name.end(), 0UL, [](unsigned long sum, char c) {
        return (sum * 31 + static_cast<unsigned char>(c)) % 1'000'003;
    });
}

class Class {
public:
    Class(fs::path folder, unsigned long every) : folder_(std::move(folder)), every_(every) {
        fs::create_directories(folder_);
    }

    [[nodiscard]] bool wants(const std::string& name, unsigned long share) const {
        const unsigned long sum = sumOf(name);
        return sum % share == 0 && sum / share % every_ == 0;
    }

    [[nodiscard]] fs::path open(const std::string& name) const {
        const fs::path folder = folder_ / name;
        fs::create_directory(folder);
        return folder;
    }

private:
    fs::path folder_;
    unsigned long every_;
};

/// False for submissions that end at a limit of time or memory, because their findings depend on
/// the machine.
bool endsByItself(const corpus::Entry& entry) {
    const corpus::Expectation& expect = entry.expected();
    return !expect.names(kRunTimedOut.id) && !expect.names(kBuildLimit.id) &&
           !expect.names(kRunMemory.id);
}

/// "sample-awarded-bump-z-up", "hostile-abort"; of a mistake its task and name.
std::string nameOf(const std::string& kind, const corpus::Entry& entry) {
    std::string name = kind + "-" + (kind == "hostile" ? "" : entry.group + "-") + entry.name;
    std::ranges::replace(name, '/', '-');
    return name;
}

/// Adds one of every `share` entries of some collections.
void add(const std::vector<corpus::Entry>& entries, const std::string& kind, unsigned long share,
         const Class& to) {
    for (const corpus::Entry& entry : entries) {
        const std::string name = nameOf(kind, entry);
        if (!to.wants(name, share) || (kind == "hostile" && !endsByItself(entry))) continue;
        const fs::path folder = to.open(name);
        corpus::writeSubmission(entry, "/nowhere/secret", folder);
        // The grader lists it as a file that does not belong to the submission.
        if (share == 1) fs::copy_file(entry.path, folder / "expected.json");
    }
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() < 2) {
        fmt::print(stderr, "golden_class ROOT CLASS [EVERY]\n");
        return 2;
    }
    const fs::path root{arguments[0]};
    const Class to{arguments[1], arguments.size() > 2 ? std::stoul(arguments[2]) : 1};
    add(corpus::readEntries(root, {"samples"}), "sample", 1, to);
    add(corpus::readEntries(root, {"unseen"}), "unseen", 1, to);
    add(corpus::readCatalogue(root), "mistake", 3, to);
    add(corpus::readEntries(root, {"hostile"}), "hostile", 3, to);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        fmt::print(stderr, "golden_class: {}\n", error.what());
        return 2;
    }
}
