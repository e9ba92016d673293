// terminal_picture OUT.png < output: draws the half blocks that tick1star --preview printed.
#include "TerminalPicture.h"

#include <raytracer/base/Error.h>
#include <raytracer/io/ImageWriter.h>

#include <cstdio>
#include <iostream>
#include <iterator>
#include <string>

int main(int argc, char* argv[]) {
    if (argc != 2) {
        std::fputs("usage: terminal_picture OUT.png < ESCAPE-CODES\n", stderr);
        return raytracer::toInt(raytracer::ExitCode::badInput);
    }
    try {
        constexpr int kPixelSide = 6;
        const std::string written{std::istreambuf_iterator<char>{std::cin}, {}};
        raytracer::writePng(ticker::enlarged(ticker::terminalPicture(written), kPixelSide),
                            argv[1]);
        return 0;
    } catch (const raytracer::Error& error) {
        std::fprintf(stderr, "terminal_picture: %s\n", error.what());
        return raytracer::toInt(error.exitCode());
    }
}
