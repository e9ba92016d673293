#include <grader/tests/layering/Includes.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

// Compares the drawing in docs/architecture.md with the #include lines.
namespace ticker {
namespace {

namespace fs = std::filesystem;
using namespace tests;

const fs::path kRoot{TICKER_SOURCE_DIR};

/// The folders that each folder includes.
using Arrows = std::map<std::string, std::set<std::string>>;

// The framework's folders are one box, and so are the folders of the grader.
std::string boxOf(const std::string& layer) {
    if (layer.starts_with("raytracer/") || layer == "app") return "framework";
    if (layer == "exercise") return "reference_solution";
    // The functions that an exercise names are linked with the probe.
    if (layer == "grader/exercises") return "probe";
    if (layer.starts_with("grader/tasks/")) return "tasks";
    return layer.starts_with("grader/") ? layer.substr(7) : layer;
}

Arrows includedArrows() {
    Arrows arrows;
    for (const fs::path& file : sources()) {
        const auto from = layerOf(file);
        if (!from) continue;
        for (const std::string& header : includesOf(file)) {
            const auto to = folderOf(header);
            if (to && boxOf(*to) != boxOf(*from)) arrows[boxOf(*from)].insert(boxOf(*to));
        }
    }
    return arrows;
}

Arrows drawnArrows() {
    static const std::regex kArrow{R"(^ *([a-z_]+) --> ([a-z_]+(?: & [a-z_]+)*)$)"};
    static const std::regex kName{"[a-z_]+"};
    Arrows arrows;
    for (const std::string& line : linesOf(kRoot / "docs/architecture.md")) {
        std::smatch match;
        if (!std::regex_match(line, match, kArrow)) continue;
        const std::string targets = match[2];
        for (std::sregex_iterator name{targets.begin(), targets.end(), kName};
             name != std::sregex_iterator{}; ++name)
            arrows[match[1]].insert(name->str());
    }
    return arrows;
}

void follow(const Arrows& arrows, const std::string& from, std::set<std::string>& reached) {
    const auto next = arrows.find(from);
    if (next == arrows.end()) return;
    for (const std::string& to : next->second)
        if (reached.insert(to).second) follow(arrows, to, reached);
}

TEST(ArchitectureDrawing, HasAPathForEveryInclude) {
    const Arrows drawn = drawnArrows();
    ASSERT_GT(drawn.size(), 15U);
    for (const auto& [from, targets] : includedArrows()) {
        std::set<std::string> reached;
        follow(drawn, from, reached);
        for (const std::string& to : targets)
            EXPECT_TRUE(reached.contains(to)) << from << " includes " << to;
    }
}

TEST(ArchitectureDrawing, HasNoRedundantArrow) {
    const Arrows included = includedArrows();
    for (const auto& [from, targets] : drawnArrows())
        for (const std::string& to : targets)
            EXPECT_TRUE(included.contains(from) && included.at(from).contains(to))
                << from << " does not include " << to;
}

TEST(ArchitectureDrawing, HasNoCircle) {
    const Arrows drawn = drawnArrows();
    for (const auto& [from, targets] : drawn) {
        std::set<std::string> reached;
        follow(drawn, from, reached);
        EXPECT_FALSE(reached.contains(from)) << from;
    }
}

}  // namespace
}  // namespace ticker
