#include "Trick.h"

#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <iostream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tricks {
namespace {

int nothing(std::span<char*>) {
    return 0;
}

int exitWith(std::span<char*> arguments) {
    return std::atoi(arguments[0]);
}

int threads(std::span<char*>) {
    std::atomic<int> sum = 0;
    {
        std::vector<std::jthread> workers;
        for (int i = 0; i < 4; ++i)
            workers.emplace_back([&sum, i] { sum += i; });
    }
    auto more = std::async(std::launch::async, [] { return 4; });
    return sum + more.get() == 10 ? 0 : 1;
}

int randomDevice(std::span<char*>) {
    std::random_device device;
    std::mt19937_64 generator{device()};
    return std::isfinite(std::normal_distribution<double>{}(generator)) ? 0 : 1;
}

int exceptions(std::span<char*>) {
    try {
        throw std::runtime_error("caught");
    } catch (const std::exception& error) {
        std::ostringstream text;
        text << error.what() << ' ' << 1.5;
        std::cout << text.str() << '\n';
        return text.str() == "caught 1.5" ? 0 : 1;
    }
}

int memory(std::span<char*>) {
    std::vector<double> values(8U << 20U, 1.0);
    values.resize(values.size() * 2);
    return values.size() == 16U << 20U ? 0 : 1;
}

// The C library's streams over an inherited descriptor.
int streamDescriptor(std::span<char*>) {
    std::FILE* stream = fdopen(1, "w");
    return stream != nullptr && std::fputs("streamed\n", stream) >= 0 && std::fclose(stream) == 0
               ? 0
               : 1;
}

// Copies from descriptor 3 to descriptor 4.
int copyDescriptors(std::span<char*>) {
    char text[64] = {};
    const ssize_t size = read(3, text, sizeof text);
    return size > 0 && write(4, text, static_cast<std::size_t>(size)) == size ? 0 : 1;
}

constexpr Trick kTricks[] = {{"nothing", nothing},
                             {"exit-with", exitWith},
                             {"threads", threads},
                             {"random-device", randomDevice},
                             {"exceptions", exceptions},
                             {"memory", memory},
                             {"stream-descriptor", streamDescriptor},
                             {"copy-descriptors", copyDescriptors}};

}  // namespace

std::span<const Trick> honest() {
    return kTricks;
}

}  // namespace tricks
