#ifndef TICKER_PIPELINE_UNPACK_H
#define TICKER_PIPELINE_UNPACK_H

#include <cstdint>
#include <string_view>

namespace ticker::pipeline {

/// True where a zlib stream (RFC 1950) is whole and unpacks to exactly so many bytes. Keeps none of
/// them and stops at the first that is too many, so that a bomb costs nothing.
[[nodiscard]] bool unpacksTo(std::uint64_t bytes, std::string_view stream);

}  // namespace ticker::pipeline

#endif
