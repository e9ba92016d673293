// fuzz_X MUTATIONS SEED: runs the initial inputs, then this many mutations of them, reproducibly. A
// short form of libFuzzer for every compiler.
#include "Fuzz.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>

namespace {

class Mutator {
public:
    explicit Mutator(unsigned long seed) : random_(seed) {}

    std::string mutated(const std::vector<std::string>& seeds) {
        std::string bytes = seeds[below(seeds.size())];
        for (std::size_t changes = 1 + below(4); changes > 0 && !bytes.empty(); --changes)
            change(bytes, seeds);
        return bytes;
    }

private:
    std::size_t below(std::size_t limit) { return random_() % limit; }

    void change(std::string& bytes, const std::vector<std::string>& seeds) {
        const std::size_t place = below(bytes.size());
        switch (below(7)) {
            case 0:
                bytes[place] = static_cast<char>(below(256));
                break;
            case 1:
                bytes[place] = static_cast<char>(bytes[place] ^ (1 << below(8)));
                break;
            case 2:
                bytes.erase(place, 1 + below(8));
                break;
            case 3:
                bytes.insert(place, bytes.substr(below(bytes.size()), 1 + below(40)));
                break;
            case 4:
                putNumber(bytes, place);
                break;
            case 5:
                splice(bytes, place, seeds[below(seeds.size())]);
                break;
            default:
                if (below(4) == 0) bytes.resize(place);
        }
    }

    // Writes a size or offset at the limits of four bytes, in either byte order.
    void putNumber(std::string& bytes, std::size_t place) {
        constexpr std::array<std::uint32_t, 7> kEdges{
            0, 1, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0xFFFFFFFE, 0x00010000};
        const std::uint32_t number = kEdges.at(below(kEdges.size()));
        const bool largestFirst = below(2) == 0;
        for (unsigned i = 0; i < 4 && place + i < bytes.size(); ++i)
            bytes[place + i] = static_cast<char>(number >> 8U * (largestFirst ? 3 - i : i));
    }

    void splice(std::string& bytes, std::size_t place, const std::string& other) {
        if (other.empty()) return;
        const std::size_t from = below(other.size());
        bytes.replace(place, 1 + below(64), other.substr(from, 1 + below(64)));
    }

    std::mt19937_64 random_;
};

struct Tally {
    long taken = 0;
    long refused = 0;

    void count(bool wasTaken) { ++(wasTaken ? taken : refused); }
};

Tally run(long mutations, unsigned long seed) {
    const std::vector<std::string> seeds = ticker::fuzz::seeds();
    Tally tally;
    for (const std::string& each : seeds)
        tally.count(ticker::fuzz::give(each));
    Mutator mutator{seed};
    for (long i = 0; i < mutations; ++i) {
        const std::string input = mutator.mutated(seeds);
        try {
            tally.count(ticker::fuzz::give(input));
        } catch (const std::exception& error) {
            std::printf("mutation %ld of seed %lu: %s\n", i, seed, error.what());
            throw;
        }
    }
    return tally;
}

}  // namespace

int main(int count, char** words) {
    if (count != 3) return 2;
    try {
        const Tally tally = run(std::atol(words[1]), std::strtoul(words[2], nullptr, 10));
        std::printf("%ld taken, %ld refused\n", tally.taken, tally.refused);
        // If all mutations are accepted, or all refused, they reach little of a reader.
        return tally.taken > 0 && tally.refused > 0 ? 0 : 1;
    } catch (const std::exception& error) {
        std::printf("%s\n", error.what());
        return 1;
    }
}
