#include "app/golden/golden_driver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <regex>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// Letters and digits in lower case, all else as single hyphens.
std::string slug(std::string_view text)
{
    std::string out;
    for (const char letter : text) {
        if (std::isalnum(static_cast<unsigned char>(letter)) != 0)
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
        else if (!out.empty() && out.back() != '-') out += '-';
    }
    while (out.ends_with('-')) out.pop_back();
    return out;
}

std::string withoutWidth(const std::string& device)
{
    static const std::regex WIDTH(", [0-9]+ bits");
    return std::regex_replace(device, WIDTH, "");
}

/// "22.3.6" of "4.5 (Core Profile) Mesa 22.3.6": the last number of several parts.
std::string versionOf(const std::string& driver)
{
    static const std::regex VERSION("[0-9]+(\\.[0-9]+)+");
    std::string version;
    for (std::sregex_iterator found(driver.begin(), driver.end(), VERSION), end; found != end; ++found)
        version = found->str();
    return version;
}

size_t commonLetters(const std::string& a, const std::string& b)
{
    return static_cast<size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

}  // namespace

std::string driverKey(const std::string& device)
{
    const size_t end = device.find_first_of("(/");
    if (device.starts_with("zink") && end != std::string::npos)
        return "zink-" + slug(device.substr(end + 1, device.find_first_of(" (/", end + 1) - end - 1));
    const std::string key = slug(device.substr(0, end));
    return key.empty() ? "unknown" : key;
}

bool isOwn(const GoldenRecord& record, const DeviceInfo& device)
{
    return record.driver == device.version && withoutWidth(record.device) == withoutWidth(device.name);
}

ChosenReference chooseReference(const Golden& golden, const DeviceInfo& device)
{
    if (golden.recorded.empty())
        throw InputError(fmt::format("{}: has no references; `knuckle golden update` makes them", golden.path()));
    const std::string own = driverKey(device.name);
    const std::string* nearest = nullptr;
    for (const auto& [key, record] : golden.recorded) {
        if (isOwn(record, device)) return {key, true};
        if (nearest == nullptr || commonLetters(key, own) > commonLetters(*nearest, own)) nearest = &key;
    }
    return {*nearest, false};
}

std::string newKey(const Golden& golden, const DeviceInfo& device)
{
    std::string key = driverKey(device.name);
    if (golden.recorded.contains(key)) key += "-" + versionOf(device.version);
    for (int i = 2; golden.recorded.contains(key); ++i)
        key = fmt::format("{}-{}-{}", driverKey(device.name), versionOf(device.version), i);
    return key;
}

}  // namespace knuckle
