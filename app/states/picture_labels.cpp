#include "app/states/picture_labels.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

struct Label {
    const char *keyword, *word;
};

constexpr const char *STATE = "knuckle:state", *DEVICE = "knuckle:device", *DRIVER = "knuckle:driver",
                     *PROGRAM = "Software", *SCENE = "knuckle:scene", *FRAME = "knuckle:frame";

constexpr std::array LABELS{Label{SCENE, "scene"},           Label{FRAME, "frame"},
                            Label{STATE, "state hash"},      Label{DEVICE, "device"},
                            Label{DRIVER, "driver"},         Label{PROGRAM, "program"},
                            Label{"knuckle:build", "build"}, Label{"knuckle:shaders", "shaders"},
                            Label{"knuckle:world", "world"}, Label{"knuckle:settings", "settings"},
                            Label{"knuckle:files", "models"}};

}  // namespace

PngText labelsOf(const RunFacts& facts, uint64_t frame, uint64_t stateHash)
{
    const RunFingerprint& print = facts.fingerprint;
    const std::array<std::string, LABELS.size()> values{
        facts.sceneName, std::to_string(frame), hashText(stateHash), print.device, print.driver, print.program,
        print.build,     print.shaders,         print.world,         print.scene,  print.files};
    PngText text;
    for (size_t k = 0; k < LABELS.size(); ++k) text.emplace_back(LABELS[k].keyword, values[k]);
    return text;
}

std::string labelLines(const std::map<std::string, std::string>& text)
{
    std::string lines;
    for (const Label& label : LABELS)
        if (const auto found = text.find(label.keyword); found != text.end())
            lines += fmt::format("  {:<14}{}\n", label.word, found->second);
    return lines;
}

std::string originsLine(const std::map<std::string, std::string>& first,
                        const std::map<std::string, std::string>& second)
{
    const auto valueOf = [](const auto& text, const char* keyword) {
        const auto found = text.find(keyword);
        return found == text.end() ? std::string() : found->second;
    };
    std::vector<std::string> phrases;
    const auto compare = [&](const char* keyword, const char* words) {
        const std::string a = valueOf(first, keyword), b = valueOf(second, keyword);
        if (!a.empty() && !b.empty() && a != b) phrases.push_back(fmt::format("{}: {} and {}", words, a, b));
        return !a.empty() && a == b;
    };
    compare(SCENE, "of different scenes");
    compare(FRAME, "of different frames");
    compare(DEVICE, "from different devices");
    compare(DRIVER, "from different drivers");
    compare(PROGRAM, "from different programs");
    if (compare(STATE, "of different states, so what was simulated differs"))
        phrases.emplace_back("of the same state, so what was drawn differs");
    return fmt::format("{}", fmt::join(phrases, "; "));
}

}  // namespace knuckle
