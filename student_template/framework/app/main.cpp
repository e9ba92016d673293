#include "Jobs.h"
#include "Options.h"
#include "view/View.h"
#include "view/Worker.h"

#include <raytracer/base/Error.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace raytracer {
namespace {

ExitCode run(const std::vector<std::string>& arguments) {
    if (!arguments.empty() && arguments.front() == view::kWorkerArgument) view::runWorker();
    const Options options = parseOptions(arguments);
    if (options.showHelp) {
        std::cout << usage();
        return ExitCode::success;
    }
    if (options.showVersion) {
        std::cout << TICK1STAR_PROGRAM " " << TICK1STAR_VERSION << '\n';
        return ExitCode::success;
    }
    if (options.view) return view::run(options);
    return options.trace ? tellOfPixel(options) : renderPicture(options);
}

}  // namespace
}  // namespace raytracer

int main(int argc, char* argv[]) {
    using namespace raytracer;
    try {
        return toInt(run({argv + std::min(argc, 1), argv + argc}));
    } catch (const Error& error) {
        std::cerr << TICK1STAR_PROGRAM ": " << error.what() << '\n';
        return toInt(error.exitCode());
    } catch (const std::exception& error) {
        std::cerr << TICK1STAR_PROGRAM ": " << error.what() << '\n';
        return toInt(ExitCode::notGradable);
    }
}
