#ifndef TICKER_PROBE_BYTESTREAM_H
#define TICKER_PROBE_BYTESTREAM_H

#include <raytracer/base/Error.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace ticker::probe {

/// Writes plain values as bytes in native byte order: both processes run on one machine.
class ByteWriter {
public:
    template <typename Value>
    void put(const Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        putBytes(&value, sizeof value);
    }

    /// The number of values, then the values.
    template <typename Value>
    void putAll(const std::vector<Value>& values) {
        static_assert(std::is_trivially_copyable_v<Value>);
        put(static_cast<std::uint64_t>(values.size()));
        putBytes(values.data(), values.size() * sizeof(Value));
    }

    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

private:
    void putBytes(const void* data, std::size_t size) {
        if (size == 0) return;
        const auto* first = static_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), first, first + size);
    }

    std::vector<std::byte> bytes_;
};

/// Reads what a `ByteWriter` wrote. Every read is checked against the number of bytes left.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    /// @throws Error if fewer bytes are left.
    template <typename Value>
    [[nodiscard]] Value get() {
        static_assert(std::is_trivially_copyable_v<Value>);
        Value value{};
        std::memcpy(&value, next(1, sizeof value), sizeof value);
        return value;
    }

    /// @throws Error if fewer bytes are left than the count requires.
    template <typename Value>
    [[nodiscard]] std::vector<Value> getAll() {
        static_assert(std::is_trivially_copyable_v<Value>);
        const auto count = get<std::uint64_t>();
        const std::byte* data = next(count, sizeof(Value));
        std::vector<Value> values(static_cast<std::size_t>(count));
        if (count > 0) std::memcpy(values.data(), data, values.size() * sizeof(Value));
        return values;
    }

    /// Reads a count of items that take at least `bytesEach` bytes each.
    /// @throws Error if the bytes left cannot hold that many.
    [[nodiscard]] std::size_t getCount(std::size_t bytesEach) {
        const auto count = get<std::uint64_t>();
        if (count > rest_.size() / bytesEach)
            throw raytracer::Error("questions: a count is larger than the message");
        return static_cast<std::size_t>(count);
    }

    [[nodiscard]] bool atEnd() const { return rest_.empty(); }

private:
    const std::byte* next(std::uint64_t count, std::size_t size) {
        if (count > rest_.size() / size)
            throw raytracer::Error("questions: the message ends too early");
        const std::byte* data = rest_.data();
        rest_ = rest_.subspan(static_cast<std::size_t>(count) * size);
        return data;
    }

    std::span<const std::byte> rest_;
};

}  // namespace ticker::probe

#endif
