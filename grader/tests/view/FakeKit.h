#ifndef TICKER_TESTS_VIEW_FAKEKIT_H
#define TICKER_TESTS_VIEW_FAKEKIT_H

#include <grader/tests/support/TemporaryFolder.h>
#include <student_template/framework/app/view/Board.h>
#include <student_template/framework/app/view/ViewHome.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <string>

namespace raytracer::view {

/// A student's folder whose compiler, program and public tests are scripts.
class FakeKit {
public:
    FakeKit() {
        home_.exercise = write("exercise/Renderer.cpp", "// TASK T2.1 begin\n").parent_path();
        home_.scenes = write("scenes/room.xml", "<scene/>").parent_path();
        home_.build = folder_.path();
        home_.target = "program";
        home_.testTarget = "tests";
        home_.cmake = script("cmake", "exit 0").string();
        home_.program = script("program", kEcho);
        home_.tests = script("tests", "exit 0");
        home_.suites = {{"T1", "BumpMapping"}, {"T2.1", "SoftShadows"}};
    }

    [[nodiscard]] ViewHome& home() { return home_; }

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        return folder_.write(name, text);
    }
    std::filesystem::path script(const std::string& name, const std::string& commands) const {
        const std::filesystem::path file = write(name, "#!/bin/sh\n" + commands + "\n");
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
        return file;
    }

private:
    // A worker that gives every command back as its answer.
    static constexpr const char* kEcho = R"(tab=$(printf '\t')
while IFS= read -r line; do
  number=${line#*"$tab"}
  printf 'failed %s %s\n%s' "${number%%"$tab"*}" "${#line}" "$line"
done)";

    ticker::tests::TemporaryFolder folder_;
    ViewHome home_;
};

/// Waits until the board's entries are as wanted and gives them; null where nothing more comes.
template <typename IsWanted>
nlohmann::json waitFor(Board& board, const IsWanted& isWanted) {
    nlohmann::json all = nlohmann::json::object();
    for (std::uint64_t version = 0;;) {
        const nlohmann::json news = nlohmann::json::parse(board.newsAfter(version));
        if (news["version"] == version) return nullptr;
        version = news["version"].get<std::uint64_t>();
        all.update(news);
        if (isWanted(all)) return all;
    }
}

}  // namespace raytracer::view

#endif
