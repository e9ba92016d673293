#include "ThisProgram.h"

#include <student_template/framework/app/view/View.h>
#include <student_template/framework/app/view/Worker.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace raytracer::view {

std::string thisProgram() {
    return std::filesystem::read_symlink("/proc/self/exe").string();
}

ViewHome homeIn(const std::filesystem::path& folder) {
    ViewHome home;
    home.exercise = folder / "exercise";
    home.scenes = folder / "scenes";
    home.build = folder;
    home.target = "program";
    home.program = folder / "program";
    home.testTarget = "tests";
    home.tests = folder / "tests";
    home.cmake = (folder / "cmake").string();
    home.suites = {{"T1", "BumpMapping"}, {"T2.1", "SoftShadows"}};
    return home;
}

const ViewHome& viewHome() {
    static const char* const kit = std::getenv(kKitVariable);
    static const ViewHome home = kit == nullptr ? ViewHome{} : homeIn(kit);
    return home;
}

}  // namespace raytracer::view

int main(int argc, char* argv[]) {
    using namespace raytracer;
    const std::vector<std::string> arguments{argv + std::min(argc, 1), argv + argc};
    const std::string first = arguments.empty() ? std::string{} : arguments.front();
    if (first == view::kWorkerArgument) view::runWorker();
    if (first == "--view") return toInt(view::run(parseOptions(arguments)));
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
