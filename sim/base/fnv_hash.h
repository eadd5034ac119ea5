#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace knuckle {

/// FNV-1a, 64 bits: of words byte by byte, the least significant first, so that it is the same on every machine.
class FnvHash {
public:
    void add(std::unsigned_integral auto word)
    {
        for (size_t k = 0; k < sizeof word; ++k) value_ = (value_ ^ (word >> (8 * k) & 0xffu)) * 0x100000001b3ull;
    }
    void add(std::string_view bytes)
    {
        for (const char byte : bytes) add(static_cast<uint8_t>(byte));
    }
    uint64_t value() const { return value_; }

private:
    uint64_t value_ = 0xcbf29ce484222325ull;
};

/// A hash in its only printed form: 16 hexadecimal digits.
std::string hashText(uint64_t hash);

}  // namespace knuckle
