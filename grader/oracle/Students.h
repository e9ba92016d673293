#ifndef TICKER_ORACLE_STUDENTS_H
#define TICKER_ORACLE_STUDENTS_H

#include <grader/oracle/Setup.h>

#include <raytracer/image/Image.h>

#include <cstdint>

namespace ticker::oracle {

/// See Oracle::studentRender.
[[nodiscard]] raytracer::Image studentRender(const Setup& setup, std::uint64_t seed);

}  // namespace ticker::oracle

#endif
