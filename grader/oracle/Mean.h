#ifndef TICKER_ORACLE_MEAN_H
#define TICKER_ORACLE_MEAN_H

#include <grader/oracle/Oracle.h>
#include <grader/oracle/Setup.h>

#include <cstdint>

namespace ticker::oracle {

/// See Oracle::moments.
[[nodiscard]] Moments momentsOf(const Setup& setup, std::uint64_t seed, const Precision& precision);

}  // namespace ticker::oracle

#endif
