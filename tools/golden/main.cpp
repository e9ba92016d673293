// golden_class ROOT CLASS [EVERY]: writes samples, unseen solutions, and a third of the catalogue
// and of the hostile cases into CLASS, one folder each. EVERY 30 keeps one entry of thirty.
#include <grader/base/WholeFile.h>
#include <grader/corpus/Catalogue.h>
#include <grader/corpus/HostileCase.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace ticker;

/// A number that depends on the name alone, so that new entries move no others in or out.
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

/// Every folder below `root` that holds a submission, named by its path.
void addFolders(const fs::path& root, const std::string& kind, const Class& to) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
        if (entry.path().filename() != "expected.json") continue;
        const fs::path from = entry.path().parent_path();
        std::string name = kind + "-" + fs::relative(from, root).string();
        std::ranges::replace(name, '/', '-');
        if (to.wants(name, 1)) fs::copy(from, to.open(name));
    }
}

void addMistakes(const fs::path& root, const Class& to) {
    for (const mistakes::Mistake& mistake : mistakes::readCatalogue(root / "grader/corpus")) {
        const std::string name = fmt::format("mistake-{}-{}", mistake.task, mistake.id);
        if (!to.wants(name, 3)) continue;
        const std::string reference =
            readWhole(root / "reference_solution/exercise" / mistake.file);
        std::ofstream stream{to.open(name) / mistake.file, std::ios::binary};
        stream << mistakes::makeMistake(mistake, reference);
    }
}

/// Left out: what ends at a limit of time or memory, because its findings depend on the machine.
bool endsByItself(const hostile::HostileCase& each) {
    return std::ranges::none_of(each.findings, [](const std::string& finding) {
        return finding == "run.timed-out" || finding == "build.limit" || finding == "run.memory";
    });
}

void addHostile(const fs::path& root, const Class& to) {
    for (const hostile::HostileCase& each :
         hostile::listHostileCases(root / "grader/corpus/hostile/cases")) {
        const std::string name = "hostile-" + each.name;
        if (to.wants(name, 3) && endsByItself(each))
            hostile::writeSubmission(each, "/nowhere/secret", to.open(name));
    }
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() < 2) {
        fmt::print(stderr, "golden_class ROOT CLASS [EVERY]\n");
        return 2;
    }
    const fs::path root{arguments[0]};
    const Class to{arguments[1], arguments.size() > 2 ? std::stoul(arguments[2]) : 1};
    addFolders(root / "grader/corpus/samples", "sample", to);
    addFolders(root / "grader/corpus/unseen", "unseen", to);
    addMistakes(root, to);
    addHostile(root, to);
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
