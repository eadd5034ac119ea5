#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>

#include "app/commands/commands.h"
#include "app/run/driver_report.h"
#include "app/states/picture_labels.h"
#include "app/states/states_text.h"
#include "render/reader/picture_file.h"
#include "sim/base/cores.h"

namespace knuckle {

namespace {

void printDevices(const std::vector<DeviceInfo>& devices)
{
    if (devices.empty()) fmt::print("EGL lists no device.\n");
    for (const DeviceInfo& device : devices) {
        fmt::print("{}  {:<8}  {}\n", device.index, device.software ? "software" : "gpu", device.name);
        fmt::print("   {}\n", device.problem.empty() ? device.version : "cannot be used: " + device.problem);
    }
}

int printFile(const std::string& file)
{
    std::string start(4, '\0');
    std::ifstream(file, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
    if (start != "\x89PNG") {
        fmt::print("{}", statesText(StatesFile(file)));
        return EXIT_FINE;
    }
    const Picture picture = readPicture(file);
    const std::string lines = labelLines(picture.text);
    fmt::print("{}: {} x {} pixels, {} bits a channel\n{}", file, picture.width, picture.height, picture.bitDepth,
               lines.empty() ? "  says nothing of where it comes from\n" : lines);
    return EXIT_FINE;
}

int info(const CommonOptions& common)
{
    fmt::print("knuckle {}\n\nDevices:\n", KNUCKLE_VERSION);
    printDevices(withPointer(listDevices));
    const auto gpu = openGpu(common);
    const DeviceLimits& limits = gpu->limits();
    fmt::print("\n--device {} takes {}: {} ({})\n", common.device, gpu->device().index, gpu->device().name,
               gpu->device().version);
    fmt::print("  largest storage buffer      {} MiB\n", limits.storageBlockSize >> 20);
    fmt::print("  storage buffers a kernel    {}\n", limits.computeStorageBlocks);
    fmt::print("  buffer textures a kernel    {}\n", limits.computeTextures);
    fmt::print("  largest buffer texture      {} texels\n", limits.textureBufferSize);
    fmt::print("  largest texture             {} pixels\n", limits.textureSize);
    fmt::print("  work groups a dispatch      {}\n", limits.workGroupCountX);
    if (!gpu->device().software) return EXIT_FINE;
    fmt::print("  threads                     {}\n", threadsText());
    fmt::print("  drawing                     {}\n",
               usableCores() > 1 ? "beside simulating the next frame, where both take long enough (see --stats)"
                                 : "after simulating: there is one core");
    return EXIT_FINE;
}

}  // namespace

void addInfoCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand(
        "info", "List the devices, and the limits of the chosen one; or tell what is in a file");
    command->fallthrough();
    command->footer("Without FILE: exit code 3, with the reason, when no device can be used.");
    auto file = std::make_shared<std::string>();
    command->add_option("FILE", *file, "A file of states, or a frame as PNG");
    command->callback([=] { line.chosen = [=] { return file->empty() ? info(line.common) : printFile(*file); }; });
}

}  // namespace knuckle
