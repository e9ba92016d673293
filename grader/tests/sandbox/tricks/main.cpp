// sandbox_tricks MARKER TRICK [ARGUMENT...]: does one trick; the marker lets a test find its
// remaining processes.
#include "Trick.h"

#include <string_view>

int main(int count, char** words) {
    if (count < 3) return 2;
    const std::span<char*> arguments{words + 3, words + count};
    for (const auto& tricks : {tricks::honest(), tricks::greedy(), tricks::prying()})
        for (const tricks::Trick& trick : tricks)
            if (std::string_view{words[2]} == trick.name) return trick.run(arguments);
    return 2;
}
