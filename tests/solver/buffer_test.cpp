#include "sim/gpu/buffer.h"

#include <filesystem>
#include <functional>
#include <numeric>

#include "sim/base/errors.h"
#include "sim/gpu/kernel.h"
#include "tests/message_of.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

/// A kernel that copies `given` to `taken`, after a delay if requested.
class BufferOrder : public testing::Test {
protected:
    // Some 20 groups, and a size that is no multiple of theirs.
    static constexpr size_t SIZE = 1203;

    BufferOrder()
    {
        gpu();
        std::filesystem::create_directories(shaderFolder().path("sim"));
        shaderFolder().write("sim/test_copy.comp", R"(#include "shared/constants.h"
layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer given;
layout(std430) buffer Taken { uint taken[]; };
void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= uint(taken.length())) return;
    uint wait = taken[k];
    for (uint i = 0u; i < wait; ++i) if (texelFetch(given, int(i % 1000u)).x == 0xffffffffu) return;
    taken[k] = texelFetch(given, int(k)).x;
}
)");
    }

    /// What the kernel finds in `given` if `thereafter` follows immediately.
    std::vector<uint32_t> found(Buffer<uint32_t>& given, const std::function<void()>& thereafter = {})
    {
        Buffer<uint32_t> taken("taken", std::span<const uint32_t>(std::vector<uint32_t>(SIZE, thereafter ? 2000 : 0)));
        BufferTable table;
        table.add(Lifetime::Scratch, given, taken);
        const Kernel kernel(gpu(), table, "sim/test_copy.comp");
        KernelTimer timer;
        kernel.dispatch(timer, groupsFor(SIZE));
        if (thereafter) thereafter();
        return taken.download();
    }
    static std::vector<uint32_t> numbers(uint32_t first)
    {
        std::vector<uint32_t> values(SIZE);
        std::iota(values.begin(), values.end(), first);
        return values;
    }
};

TEST_F(BufferOrder, WhatADeviceCannotBindAsAWholeIsRefused)
{
    const DeviceLimits& limits = gpu().limits();
    const auto said = [&](size_t givenBytes, size_t takenBytes) {
        const Buffer<uint32_t> small("small", SIZE);
        RawBuffer given = RawBuffer::standIn("given", small.id(), givenBytes);
        RawBuffer taken = RawBuffer::standIn("taken", small.id(), takenBytes);
        BufferTable table;
        table.add("given", given, elementType<uint32_t>(), Lifetime::Scratch);
        table.add("taken", taken, elementType<uint32_t>(), Lifetime::Scratch);
        const Kernel kernel(gpu(), table, "sim/test_copy.comp");
        return messageOf<DeviceError>([&] { kernel.checkSizes(gpu()); });
    };
    const auto texels = static_cast<size_t>(limits.textureBufferSize) * sizeof(uint32_t);
    const auto block = static_cast<size_t>(limits.storageBlockSize);
    EXPECT_EQ(said(texels, block), "");
    EXPECT_NE(said(texels + 4, block).find("for \"given\" and the device allows"), std::string::npos);
    EXPECT_NE(said(texels, block + 4).find("kernel test_copy needs"), std::string::npos) << said(texels, block + 4);
}

TEST_F(BufferOrder, WhatIsWrittenAfterAClearIsSeen)
{
    for (uint32_t round = 1; round <= 5; ++round) {
        Buffer<uint32_t> given("given", SIZE);
        given.upload(std::span<const uint32_t>(numbers(round)));
        ASSERT_EQ(found(given), numbers(round)) << round;
    }
}

TEST_F(BufferOrder, WhatIsWrittenAfterACopyIsSeen)
{
    for (uint32_t round = 1; round <= 5; ++round) {
        Buffer<uint32_t> given("given", std::span<const uint32_t>(numbers(round)));
        given.resize("given", SIZE + round);
        given.resize("given", SIZE);
        ASSERT_EQ(found(given), numbers(round)) << round;
        given.resize("given", SIZE + 1);
        std::vector<uint32_t> longer = numbers(round + 7);
        longer.push_back(9);
        given.upload(std::span<const uint32_t>(longer));
        ASSERT_EQ(found(given), numbers(round + 7)) << round;
    }
}

TEST_F(BufferOrder, AKernelSeesNothingOfWhatIsWrittenAfterIt)
{
    for (uint32_t round = 1; round <= 5; ++round) {
        Buffer<uint32_t> given("given", std::span<const uint32_t>(numbers(round)));
        ASSERT_EQ(found(given, [&] { given.upload(std::span<const uint32_t>(numbers(0))); }), numbers(round)) << round;
        const Buffer<uint32_t> other("other", std::span<const uint32_t>(numbers(9)));
        ASSERT_EQ(found(given, [&] { given.copy(other, SIZE * sizeof(uint32_t), 0, 0); }), numbers(0)) << round;
        ASSERT_EQ(found(given, [&] { given.clear(); }), numbers(9)) << round;
        ASSERT_EQ(found(given), std::vector<uint32_t>(SIZE, 0)) << round;
    }
}

}  // namespace

}  // namespace knuckle::test
