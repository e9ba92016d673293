#ifndef TICKER_TESTS_CLI_GRADEDCLASS_H
#define TICKER_TESTS_CLI_GRADEDCLASS_H

#include "RunningTicker.h"

#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace ticker::cli {

/// A small class with odd names, and the files that grading writes.
class GradedClass : public testing::Test {
protected:
    GradedClass() {
        namespace fs = std::filesystem;
        fs::create_directory(at("class"));
        const fs::path samples = fs::path{TICKER_SOURCE_DIR} / "grader/corpus/samples";
        // One slow submission with a finding; the others are fast.
        for (const char* name : {"ann", "bob, jr", "J\xC3\xBCrgen \"<b>\"_7", "zo\xC3\xAB"})
            fs::copy(samples / "notAwarded/template-untouched", at("class") / name,
                     fs::copy_options::recursive);
        fs::copy(samples / "notAwarded/bump-inverted-u", at("class") / "=1+1",
                 fs::copy_options::recursive);
    }

    [[nodiscard]] std::filesystem::path at(const std::string& name) const {
        return folder_.path() / name;
    }

    [[nodiscard]] std::vector<std::string> gradeCommand(
        const std::string& out, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{
            "grade", at("class").string(), "-o", at(out).string(), "--jobs", "2"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    /// Runs ticker; its exit status must be `status`. @return  The lines of its stdout.
    std::vector<std::string> run(const std::vector<std::string>& command, int status = 0) const {
        RunningTicker ticker{command, at("errors").string()};
        std::vector<std::string> lines;
        while (const auto line = ticker.readLine())
            lines.push_back(*line);
        EXPECT_EQ(ticker.wait(), status) << errors();
        return lines;
    }

    /// The stderr of the last run.
    [[nodiscard]] std::string errors() const { return textOf(at("errors")); }

    [[nodiscard]] static std::string textOf(const std::filesystem::path& file) {
        std::ifstream stream{file, std::ios::binary};
        return {std::istreambuf_iterator<char>{stream}, {}};
    }

    /// A result without its timing.
    [[nodiscard]] static nlohmann::json untimed(const std::filesystem::path& file) {
        nlohmann::json result = nlohmann::json::parse(textOf(file));
        result.erase("timing");
        return result;
    }

    static std::size_t countKept(const std::vector<std::string>& lines) {
        std::size_t kept = 0;
        for (const std::string& line : lines)
            kept += line.ends_with("[kept]") ? 1 : 0;
        return kept;
    }

private:
    tests::TemporaryFolder folder_;
};

}  // namespace ticker::cli

#endif
