#include "app/film/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/base/errors.h"
#include "sim/base/files/endings.h"

namespace knuckle {

std::string parseRecord(const std::string& text)
{
    constexpr std::string_view WORD = "states=";
    if (!text.starts_with(WORD) || text.size() == WORD.size())
        throw InputError(fmt::format("--record {}: must be states=FILE", text));
    return text.substr(WORD.size());
}

Recording::Recording(const RecordOptions& options, const Scene& scene, const RunFacts& facts, uint64_t first,
                     uint64_t last)
    : first_(first), last_(last)
{
    if (!options.states.empty()) states_.emplace(options.states, scene, facts);
    if (!options.last.empty()) end_.emplace(options.last, scene, facts);
    const double second = std::max(1.0, std::round(scene.framesPerSecond));
    every_ = options.every > 0 ? options.every : static_cast<uint64_t>(second);
}

void Recording::frame(const FrameRecord& record)
{
    for (std::optional<StatesWriter>* writer : {&states_, &end_}) {
        if (!*writer || (writer == &end_ && !isLast(record.number))) continue;
        if (record.view && wantsView(record.number)) (*writer)->addFrame(record.number, *record.view);
        if (record.state && wantsState(record.number)) (*writer)->addState(*record.state);
    }
}

void Recording::finish()
{
    if (states_) states_->commit();
    if (end_) end_->commit();
}

}  // namespace knuckle
