#include "app/doctor/driver_findings.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "app/doctor/bounded.h"
#include "app/doctor/vendors.h"
#include "app/json/json.h"
#include "render/output/ffmpeg.h"
#include "sim/base/errors.h"
#include "sim/gpu/device/driver_advice.h"
#include "sim/gpu/device/libraries.h"
#include "sim/gpu/program.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr int LIBRARY_SECONDS = 10;
constexpr int DEVICE_SECONDS = 40;  // the driver of a large GPU takes some seconds to wake it
/// Compiled on trial.
constexpr const char* KERNEL = "sim/particle/state_hash.comp";
constexpr const char* MESA = "install libegl1, libegl-mesa0 and libgl1-mesa-dri (Mesa), or the vendor's driver";

/// Why none of the libraries can be loaded, in a process of its own; empty: one can.
std::string boundedLoadProblem(const std::vector<std::string>& libraries)
{
    const BoundedResult result = runBounded([&] { return loadProblem(libraries); }, LIBRARY_SECONDS);
    return result.failure.empty() ? result.text : result.failure;
}

void findLibraries(Findings& findings)
{
    const auto library = [&](const std::vector<std::string>& names, const std::string& remedy) {
        const std::string problem = boundedLoadProblem(names);
        if (problem.empty()) findings.push_back({Health::Ok, fmt::format("library {}", names[0])});
        else findings.push_back({Health::Wrong, fmt::format("library {}: {}", names[0], problem), remedy});
    };
    library({"libEGL.so.1"}, "install libegl1, and libgl1-mesa-dri (Mesa) or the vendor's driver");
    library(OPENGL_LIBRARIES, "install libopengl0");
}

void findVendors(Findings& findings, bool usable)
{
    const std::vector<EglVendor> vendors = eglVendors("");
    if (vendors.empty())
        findings.push_back({usable ? Health::Note : Health::Wrong,
                            fmt::format("EGL drivers: no file in {} names one", eglVendorPlaces("")),
                            usable ? "" : MESA});
    for (const EglVendor& vendor : vendors) {
        const std::string problem = vendor.library.empty() ? "it names no library"
                                                           : boundedLoadProblem({vendor.library});
        if (problem.empty())
            findings.push_back({Health::Ok, fmt::format("EGL driver {}, of {}", vendor.library, vendor.file)});
        else
            findings.push_back({usable ? Health::Note : Health::Wrong,
                                fmt::format("EGL driver of {}: {}", vendor.file, problem),
                                "install the driver that it belongs to, or remove the file"});
    }
}

Json devicesAsJson()
{
    Json list = Json::array();
    for (const DeviceInfo& device : listDevices())
        list.push_back({device.index, device.software, device.name, device.version, device.problem});
    return list;
}

Json chosenAsJson(const CommonOptions& common)
{
    Gpu gpu(DeviceChoice::parse(common.device), common.shaderFolder);
    Program::compute(gpu, KERNEL);
    gpu.checkErrors();
    return {gpu.device().index, gpu.device().software, gpu.device().name, gpu.limits().storageBlockSize};
}

void findDevices(DriverFindings& driver, const BoundedResult& listed)
{
    if (!listed.failure.empty()) {
        const bool hasRemedy = listed.failure.find("; ") != std::string::npos;
        driver.findings.push_back(
            {Health::Wrong, "devices: " + listed.failure, driver.usable || hasRemedy ? "" : MESA});
        return;
    }
    const Json devices = Json::parse(listed.text);
    if (devices.empty()) driver.findings.push_back({Health::Wrong, "devices: EGL lists none", MESA});
    for (const Json& device : devices) {
        const std::string name = fmt::format("device {} ({}): {}", device[0].get<uint32_t>(),
                                             device[1].get<bool>() ? "software" : "gpu", device[2].get<std::string>());
        const std::string problem = device[4];
        if (problem.empty())
            driver.findings.push_back({Health::Ok, fmt::format("{}, OpenGL {}", name, device[3].get<std::string>())});
        else
            driver.findings.push_back({driver.usable ? Health::Note : Health::Wrong,
                                       fmt::format("{} cannot be used: {}", name, problem),
                                       driver.usable ? "" : "update its driver, or choose another --device"});
    }
}

/// The error of opening it for use, 0 if there is none. Containers may refuse that whatever the file's rights say.
int openProblem(const std::string& file)
{
    const int descriptor = open(file.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) return errno;
    close(descriptor);
    return 0;
}

/// @throws InputError, as all commands do, for the number of no device. Where none is listed, the machine is at fault.
void refuseAbsent(const DeviceChoice& choice, const BoundedResult& listed, const BoundedResult& chosen)
{
    if (choice.kind != DeviceChoice::Kind::Index || !listed.failure.empty() || chosen.failure.empty()) return;
    const size_t count = Json::parse(listed.text).size();
    if (count > 0 && choice.index >= count) throw InputError(chosen.failure);
}

}  // namespace

DriverFindings findDriver(const CommonOptions& common)
{
    const DeviceChoice choice = DeviceChoice::parse(common.device);
    DriverFindings driver;
    findLibraries(driver.findings);
    const BoundedResult listed = runBounded([] { return devicesAsJson().dump(); }, DEVICE_SECONDS);
    const BoundedResult chosen = runBounded([&] { return chosenAsJson(common).dump(); }, DEVICE_SECONDS);
    driver.usable = chosen.failure.empty();
    refuseAbsent(choice, listed, chosen);
    findVendors(driver.findings, driver.usable);
    findDevices(driver, listed);
    if (!driver.usable) {
        const bool namesIt = chosen.failure.starts_with("--device ");
        driver.findings.push_back(
            {Health::Wrong, (namesIt ? "" : fmt::format("--device {}: ", common.device)) + chosen.failure});
    } else {
        const Json device = Json::parse(chosen.text);
        driver.software = device[1];
        driver.findings.push_back(
            {Health::Ok, fmt::format("--device {} takes device {}, which compiles shaders; its "
                                     "storage buffers have {} MiB",
                                     common.device, device[0].get<uint32_t>(), device[3].get<int64_t>() >> 20)});
    }
    if (const std::string set = driverVariables(); !set.empty())
        driver.findings.push_back({driver.usable ? Health::Note : Health::Wrong, "the environment has " + set,
                                   driver.usable ? "" : "unset that"});
    for (const Findings& more : {findGpuFiles(""), findNvidia("")})
        driver.findings.insert(driver.findings.end(), more.begin(), more.end());
    return driver;
}

Findings findGpuFiles(const std::string& root)
{
    const std::string folder = root + "/dev/dri";
    std::error_code error;
    Findings findings;
    uint32_t count = 0;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string file = entry->path().string();
        if (!entry->path().filename().string().starts_with("renderD")) continue;
        ++count;
        const int problem = openProblem(file);
        if (problem == 0) findings.push_back({Health::Ok, file + " can be used"});
        else if (problem == EACCES || problem == EPERM)
            findings.push_back({Health::Wrong, file + " is a GPU that this user may not use",
                                "add the user to its group (usermod -aG render,video USER) and log in again; to a "
                                "container give --device /dev/dri --group-add render"});
        else findings.push_back({Health::Note, fmt::format("{} is no GPU: {}", file, std::strerror(problem))});
    }
    if (count == 0 && error && error != std::errc::no_such_file_or_directory)
        findings.push_back({Health::Wrong, fmt::format("{} cannot be read: {}", folder, error.message()),
                            "add the user to the groups render and video"});
    else if (count == 0)
        findings.push_back({Health::Note, fmt::format("no GPU for Mesa: there is no {}/renderD*", folder)});
    return findings;
}

Findings findNvidia(const std::string& root)
{
    std::error_code ignored;
    const bool isThere = fs::exists(root + "/dev/nvidiactl", ignored) || fs::exists(root + "/dev/nvidia0", ignored) ||
                         (root.empty() && !findProgram("nvidia-smi").empty());
    if (!isThere) return {};
    const std::vector<EglVendor> vendors = eglVendors(root);
    const bool isKnown = std::ranges::any_of(
        vendors, [](const EglVendor& vendor) { return vendor.library.find("libEGL_nvidia") != std::string::npos; });
    if (isKnown) return {{Health::Ok, "NVIDIA: its GPU is there, and so is its EGL driver"}};
    return {{Health::Wrong,
             "NVIDIA: its GPU is there, but no EGL driver: " + eglVendorPlaces(root) + " names no libEGL_nvidia",
             "start the container with NVIDIA_DRIVER_CAPABILITIES=all (compute,utility is no OpenGL); elsewhere "
             "install the driver's libraries for OpenGL (libnvidia-gl)"}};
}

}  // namespace knuckle
