#include <grader/tests/layering/Includes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// Compares the #include lines of the whole project with layers.txt, and searches headers for names
// of packages that no header may contain.
namespace ticker {
namespace {

namespace fs = std::filesystem;
using namespace tests;

const fs::path kSources{TICKER_SOURCE_DIR};

struct Layer {
    std::set<std::string> folders;
    std::set<std::string> packages;
};

std::map<std::string, Layer> readLayers() {
    std::ifstream file{kSources / "grader/tests/layering/layers.txt"};
    std::map<std::string, Layer> layers;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() == '#') continue;
        std::istringstream words{line};
        std::string name;
        words >> name;
        Layer layer;
        bool afterBar = false;
        for (std::string word; words >> word;) {
            if (word == "|")
                afterBar = true;
            else
                (afterBar ? layer.packages : layer.folders).insert(word);
        }
        layers[name] = layer;
    }
    return layers;
}

// A task's folder needs no line of its own unless it includes more than such folders do.
constexpr const char* kAnyTask = "grader/tasks/*";

bool isTask(const std::string& folder) {
    return folder.starts_with("grader/tasks/");
}

const Layer* lineOf(const std::string& folder, const std::map<std::string, Layer>& layers) {
    const auto own = layers.find(folder);
    if (own != layers.end()) return &own->second;
    return isTask(folder) ? &layers.at(kAnyTask) : nullptr;
}

bool mayInclude(const Layer& from, const std::string& self, const std::string& to) {
    return self == to || from.folders.contains(to) ||
           (isTask(to) && from.folders.contains(kAnyTask));
}

std::optional<std::string> packageOf(const std::string& header) {
    static const std::array<std::pair<const char*, const char*>, 19> kPackages{{
        {"opencv2/", "opencv"},
        {"tinyxml2.h", "tinyxml2"},
        {"stb_", "stb"},
        {"stb/", "stb"},
        {"sqlite3.h", "sqlite3"},
        {"seccomp.h", "seccomp"},
        {"archive", "archive"},
        {"nlohmann/", "json"},
        {"CLI/", "cli11"},
        {"fmt/", "fmt"},
        {"hwy/", "hwy"},
        {"cmark.h", "cmark"},
        {"httplib.h", "httplib"},
        {"gtest/", "gtest"},
        {"benchmark/", "benchmark"},
        {"zlib.h", "zlib"},
        {"tiffio.h", "tiff"},
        {"openssl/", "openssl"},
        {"png.h", "png"},
    }};
    for (const auto& [prefix, name] : kPackages)
        if (header.rfind(prefix, 0) == 0) return name;
    return std::nullopt;
}

TEST(Layering, EveryIncludePointsDownTheArrowsOfTheDesign) {
    const std::map<std::string, Layer> layers = readLayers();
    ASSERT_GT(layers.size(), 20U);
    int checked = 0;
    for (const fs::path& file : sources()) {
        const std::optional<std::string> layer = layerOf(file);
        if (!layer) continue;
        const Layer* line = lineOf(*layer, layers);
        if (line == nullptr) {
            ADD_FAILURE() << file << ": folder " << *layer << " has no line in layers.txt";
            continue;
        }
        for (const std::string& header : includesOf(file)) {
            ++checked;
            if (const auto folder = folderOf(header)) {
                EXPECT_TRUE(mayInclude(*line, *layer, *folder))
                    << file << " may not include <" << header << ">: see layers.txt";
            } else if (const auto package = packageOf(header)) {
                EXPECT_TRUE(line->packages.contains(*package))
                    << file << " may not use the package of <" << header << ">: see layers.txt";
            }
        }
    }
    EXPECT_GT(checked, 100);
}

TEST(Layering, NoHeaderSpellsTheNameOfAPackageThatMustStayHidden) {
    static const std::regex kHidden{R"(\bcv::|\btinyxml2::|\bstbi_|\bsqlite3|\bseccomp_|\bscmp_)"};
    for (const fs::path& file : sources()) {
        if (file.extension() != ".h") continue;
        int number = 0;
        for (const std::string& line : linesOf(file)) {
            ++number;
            EXPECT_FALSE(std::regex_search(line, kHidden)) << file << ":" << number << ": " << line;
        }
    }
}

TEST(Layering, EveryHeaderHasAnIncludeGuardNamedAfterItsPath) {
    for (const fs::path& file : sources()) {
        // Highway includes its -inl.h files once for each instruction set.
        const bool perTarget = file.stem().string().ends_with("-inl");
        if (file.extension() != ".h" || perTarget) continue;
        const std::vector<std::string> lines = linesOf(file);
        std::string stem = file.stem().string();
        std::transform(stem.begin(), stem.end(), stem.begin(), [](unsigned char c) {
            return std::isalnum(c) != 0 ? static_cast<char>(std::toupper(c)) : '_';
        });
        const bool guarded = std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
            return line.rfind("#ifndef ", 0) == 0 && line.find(stem + "_H") != std::string::npos;
        });
        EXPECT_TRUE(guarded) << file;
    }
}

TEST(Layering, EveryFolderOfTheGraderSaysInAFewLinesWhatItIs) {
    int folders = 0;
    for (const auto& entry : fs::directory_iterator{kSources / "grader"}) {
        if (!entry.is_directory()) continue;
        ++folders;
        const fs::path readme = entry.path() / "README.md";
        EXPECT_TRUE(fs::exists(readme)) << readme;
    }
    EXPECT_GT(folders, 20);
}

}  // namespace
}  // namespace ticker
