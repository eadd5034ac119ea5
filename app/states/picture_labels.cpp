#include "app/states/picture_labels.h"

#include <fmt/format.h>

#include <array>

#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

struct Label {
    const char *keyword, *word;
};

constexpr std::array LABELS{
    Label{"knuckle:scene", "scene"},       Label{"knuckle:frame", "frame"},     Label{"knuckle:state", "state hash"},
    Label{"knuckle:device", "device"},     Label{"knuckle:driver", "driver"},   Label{"Software", "program"},
    Label{"knuckle:build", "build"},       Label{"knuckle:shaders", "shaders"}, Label{"knuckle:world", "world"},
    Label{"knuckle:settings", "settings"}, Label{"knuckle:files", "models"}};

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

}  // namespace knuckle
