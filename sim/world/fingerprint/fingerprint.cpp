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

class FieldHash : public FnvHash {
public:
    using FnvHash::add;
    void add(float value) { add(std::bit_cast<uint32_t>(value)); }
    void add(double value) { add(std::bit_cast<uint64_t>(value)); }
    void add(bool value) { add(static_cast<uint8_t>(value)); }
    void add(int value) { add(static_cast<uint32_t>(value)); }
    template <typename T>
    requires std::is_enum_v<T>
    void add(T value) { add(static_cast<std::underlying_type_t<T>>(value)); }
    template <typename Scalar, int ROWS>
    void add(const Eigen::Matrix<Scalar, ROWS, 1>& vector)
    {
        for (const Scalar value : vector) add(value);
    }
    void add(const Quaternionf& rotation) { add(rotation.coeffs()); }
    /// With its length, so that what ends one list does not begin the next.
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
    template <typename T>
    requires requires(const T& item) { fieldsOf(item); }
    void add(const T& item)
    {
        std::apply([this](const auto&... fields) { (add(fields), ...); }, fieldsOf(item));
    }
};

}  // namespace

uint64_t fingerprint(const World& world)
{
    FieldHash hash;
    hash.add(world);
    return hash.value();
}

}  // namespace knuckle
