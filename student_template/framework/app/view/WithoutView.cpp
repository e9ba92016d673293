// Takes the place of all the rest where there is no cpp-httplib.
#include "View.h"
#include "Worker.h"

#include <cstdlib>

namespace raytracer::view {

ExitCode run(const Options& /*options*/) {
    throw InputError("", 0,
                     "--view needs cpp-httplib, which was not there when this was built. Install "
                     "it (Debian, Ubuntu: libcpp-httplib-dev; macOS: brew install cpp-httplib; "
                     "vcpkg: cpp-httplib), remove the folder build and build again");
}

void runWorker() {
    std::_Exit(toInt(ExitCode::badInput));
}

}  // namespace raytracer::view
