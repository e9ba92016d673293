#ifndef TICKER_TESTS_VIEW_FAKEKIT_H
#define TICKER_TESTS_VIEW_FAKEKIT_H

#include "ThisProgram.h"

#include <grader/tests/support/TemporaryFolder.h>
#include <student_template/framework/app/view/Board.h>
#include <student_template/framework/app/view/ViewHome.h>

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>

namespace raytracer::view {

/// A student's folder whose compiler, program and public tests are scripts.
class FakeKit {
public:
    /// A worker that gives every command back as its answer.
    static constexpr const char* kEcho = R"(tab=$(printf '\t')
while IFS= read -r line; do
  number=${line#*"$tab"}
  printf 'failed %s %s\n%s' "${number%%"$tab"*}" "${#line}" "$line"
done)";

    explicit FakeKit(const std::string& program = kEcho) {
        write("exercise/Renderer.cpp", "// TASK T2.1 begin\n");
        write("scenes/room.xml", "<scene/>");
        script("cmake", "exit 0");
        script("program", program);
        script("tests", "exit 0");
    }

    [[nodiscard]] ViewHome& home() { return home_; }
    [[nodiscard]] const ViewHome& home() const { return home_; }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        return folder_.write(name, text);
    }
    std::filesystem::path script(const std::string& name, const std::string& commands) const {
        const std::filesystem::path file = write(name, "#!/bin/sh\n" + commands + "\n");
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
        return file;
    }

private:
    ticker::tests::TemporaryFolder folder_;
    ViewHome home_ = homeIn(folder_.path());
};

/// The script of a right solution.
[[nodiscard]] inline std::string rightSolution() {
    return "exec '" + thisProgram() + "' \"$@\"";
}

/// A ball over a floor, and one light.
inline constexpr const char* kBallOverFloor = R"(<scene>
  <ambient-light colour="#202020"/>
  <point-light x="2" y="3" z="1" colour="#ffffff" intensity="100"/>
  <sphere x="0" y="0" z="4" radius="1" colour="#ff0000"/>
  <plane x="0" y="-1" z="0" nx="0" ny="1" nz="0" colour="#00ff00"/>
</scene>)";

/// While it lives, the system gives this program two files more: too few for a process. Two,
/// because the sanitizer opens a pipe to look at an exception that is caught.
class FewFiles {
public:
    FewFiles() {
        getrlimit(RLIMIT_NOFILE, &before_);
        const int first = open("/dev/null", O_RDONLY);
        const int second = open("/dev/null", O_RDONLY);
        const rlimit few{static_cast<rlim_t>(std::max(first, second)) + 1, before_.rlim_max};
        setrlimit(RLIMIT_NOFILE, &few);
        close(first);
        close(second);
    }
    ~FewFiles() { setrlimit(RLIMIT_NOFILE, &before_); }
    FewFiles(const FewFiles&) = delete;
    FewFiles& operator=(const FewFiles&) = delete;

private:
    rlimit before_{};
};

/// Waits until the board's entries are as wanted and gives them; null where nothing more comes.
template <typename IsWanted>
nlohmann::json waitFor(Board& board, const IsWanted& isWanted) {
    // The board waits for ten seconds at a time: too short where others take the processors.
    constexpr int kMostInVain = 6;
    nlohmann::json all = nlohmann::json::object();
    std::uint64_t version = 0;
    for (int inVain = 0; inVain < kMostInVain;) {
        const nlohmann::json news = nlohmann::json::parse(board.newsAfter(version));
        inVain = news["version"] == version ? inVain + 1 : 0;
        if (inVain > 0) continue;
        version = news["version"].get<std::uint64_t>();
        all.update(news);
        if (isWanted(all)) return all;
    }
    return nullptr;
}

}  // namespace raytracer::view

#endif
