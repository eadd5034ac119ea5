#include "sim/world/fingerprint/fingerprint.h"

#include <array>
#include <bit>
#include <optional>
#include <tuple>
#include <type_traits>
#include <vector>

#include "sim/base/fnv_hash.h"
#include "sim/world/fingerprint/fields.h"

namespace knuckle {

namespace {

class FieldHash {
public:
    template <typename T>
    void add(const T& value)
    {
        if constexpr (std::is_same_v<T, bool>) words_.add(static_cast<uint8_t>(value));
        else if constexpr (std::is_unsigned_v<T>) words_.add(value);
        else if constexpr (std::is_same_v<T, int>) words_.add(static_cast<uint32_t>(value));
        else if constexpr (std::is_same_v<T, float>) words_.add(std::bit_cast<uint32_t>(value));
        else if constexpr (std::is_same_v<T, double>) words_.add(std::bit_cast<uint64_t>(value));
        else if constexpr (std::is_enum_v<T>) add(static_cast<std::underlying_type_t<T>>(value));
        else std::apply([this](const auto&... fields) { (add(fields), ...); }, fieldsOf(value));
    }
    template <typename Scalar, int ROWS>
    void add(const Eigen::Matrix<Scalar, ROWS, 1>& vector)
    {
        for (const Scalar value : vector) add(value);
    }
    void add(const Quaternionf& rotation) { add(rotation.coeffs()); }
    /// Includes its length, so that the end of one list is not taken for the start of the next.
    template <typename T>
    void add(const std::vector<T>& list)
    {
        add(uint64_t{list.size()});
        for (const T& item : list) add(item);
    }
    template <typename T, size_t COUNT>
    void add(const std::array<T, COUNT>& items)
    {
        for (const T& item : items) add(item);
    }
    template <typename T>
    void add(const std::optional<T>& item)
    {
        add(item.has_value());
        if (item) add(*item);
    }
    uint64_t value() const { return words_.value(); }

private:
    FnvHash words_;
};

}  // namespace

uint64_t fingerprint(const World& world)
{
    FieldHash hash;
    hash.add(world);
    return hash.value();
}

}  // namespace knuckle
