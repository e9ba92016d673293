#ifndef RAYTRACER_MATH_RANDOM_H
#define RAYTRACER_MATH_RANDOM_H

#include <cstdint>

namespace raytracer {

/// A random number in [low, high), uniform, from the calling thread's generator. Threads that were
/// not seeded draw different numbers, which depend on the order of their first draws.
[[nodiscard]] double randomBetween(double low, double high);

/// Restarts the calling thread's generator: equal seeds give equal draws on every machine.
void seedRandom(std::uint64_t seed);

}  // namespace raytracer

#endif
