#include <gtest/gtest.h>

#include "app/golden/golden_driver.h"
#include "sim/base/errors.h"

namespace knuckle::test {
namespace {

DeviceInfo device(const std::string& name, const std::string& version)
{
    DeviceInfo info;
    info.name = name;
    info.version = version;
    return info;
}

const DeviceInfo LLVMPIPE = device("llvmpipe (LLVM 15.0.6, 256 bits)", "4.5 (Core Profile) Mesa 22.3.6");

TEST(GoldenDriver, HasAShortName)
{
    EXPECT_EQ(driverKey("llvmpipe (LLVM 15.0.6, 256 bits)"), "llvmpipe");
    EXPECT_EQ(driverKey("zink Vulkan 1.4(llvmpipe (LLVM 19.1.7, 256 bits) (LLVMPIPE))"), "zink-llvmpipe");
    EXPECT_EQ(driverKey("NVIDIA H100 PCIe/PCIe/SSE2"), "nvidia-h100-pcie");
    EXPECT_EQ(driverKey("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"), "mesa-intel");
    EXPECT_EQ(driverKey("AMD Radeon RX 7900 XTX (radeonsi, navi31, LLVM 19.1.7)"), "amd-radeon-rx-7900-xtx");
    EXPECT_EQ(driverKey("(?)"), "unknown");
}

TEST(GoldenDriver, TakesItsOwnReferencesElseTheNearest)
{
    Golden golden;
    golden.recorded["llvmpipe"] = {LLVMPIPE.version, LLVMPIPE.name, "", {}};
    golden.recorded["nvidia-h100-pcie"] = {"4.6.0 NVIDIA 535.1", "NVIDIA H100 PCIe/PCIe/SSE2", "", {}};
    const auto expect = [&](const DeviceInfo& here, const std::string& key, bool own) {
        const ChosenReference reference = chooseReference(golden, here);
        EXPECT_EQ(reference.key, key) << here.name;
        EXPECT_EQ(reference.own, own) << here.name;
    };
    expect(LLVMPIPE, "llvmpipe", true);
    expect(device("llvmpipe (LLVM 15.0.6, 512 bits)", LLVMPIPE.version), "llvmpipe", true);
    expect(device("llvmpipe (LLVM 19.1.7, 256 bits)", "4.5 (Core Profile) Mesa 25.0.7"), "llvmpipe", false);
    expect(device("NVIDIA H200/PCIe/SSE2", "4.6.0 NVIDIA 535.1"), "nvidia-h100-pcie", false);
    EXPECT_THROW(chooseReference({}, LLVMPIPE), InputError);
}

TEST(GoldenDriver, GivesANewNameBesideOthers)
{
    Golden golden;
    const DeviceInfo newer = device("llvmpipe (LLVM 19.1.7, 256 bits)", "4.5 (Core Profile) Mesa 25.0.7-2");
    EXPECT_EQ(newKey(golden, newer), "llvmpipe");
    golden.recorded["llvmpipe"];
    EXPECT_EQ(newKey(golden, newer), "llvmpipe-25.0.7");
    golden.recorded["llvmpipe-25.0.7"];
    EXPECT_EQ(newKey(golden, newer), "llvmpipe-25.0.7-2");
}

}  // namespace
}  // namespace knuckle::test
