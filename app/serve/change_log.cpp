#include "app/serve/change_log.h"

#include <fmt/format.h>

#include <array>
#include <fstream>

#include "app/json/json.h"
#include "sim/base/errors.h"
#include "sim/base/fnv_hash.h"

namespace knuckle {

namespace {

constexpr const char* FORMAT = "knuckle changes 1";

Json listOf(const Eigen::Vector3f& v)
{
    return {v.x(), v.y(), v.z()};
}

Eigen::Vector3f vectorOf(const Json& json)
{
    const auto list = json.get<std::array<float, 3>>();
    return {list[0], list[1], list[2]};
}

Json jsonOf(uint64_t step, const Change& change)
{
    Json json{{"step", step}};
    switch (change.kind) {
        case ChangeKind::Push:
            json["push"] = change.name;
            json["impulse"] = listOf(change.impulse);
            json["at"] = listOf(change.at);
            break;
        case ChangeKind::Release: json["release"] = change.name; break;
        case ChangeKind::Reset: json["reset"] = true; break;
    }
    return json;
}

Change changeOf(const Json& json)
{
    if (json.contains("reset")) return {.kind = ChangeKind::Reset};
    if (json.contains("release")) return {.kind = ChangeKind::Release, .name = json.at("release").get<std::string>()};
    return {.kind = ChangeKind::Push,
            .name = json.at("push").get<std::string>(),
            .impulse = vectorOf(json.at("impulse")),
            .at = vectorOf(json.at("at"))};
}

/// One line of a log after the first.
void readLine(const Json& json, LoggedChanges& logged)
{
    if (!logged.hash.empty()) throw InputError("comes after the end");
    const uint64_t step = json.at("step").get<uint64_t>();
    if (step < logged.steps) throw InputError("its step is before that of the line above");
    logged.steps = step;
    if (json.contains("end")) {
        logged.hash = json.at("end").get<std::string>();
        return;
    }
    const Change change = changeOf(json);
    // The state is that of the start then, whatever came before.
    if (change.kind == ChangeKind::Reset) logged = {};
    else logged.changes.push_back({step, change});
}

}  // namespace

ChangeLog::ChangeLog(const std::string& path, const std::string& scene, uint64_t world) : file_(path)
{
    file_.write(Json{{"format", FORMAT}, {"scene", scene}, {"world", hashText(world)}}.dump() + "\n");
    file_.appear();
}

void ChangeLog::add(uint64_t step, const Change& change)
{
    file_.write(jsonOf(step, change).dump() + "\n");
}

void ChangeLog::finish(uint64_t step, uint64_t stateHash)
{
    file_.write(Json{{"step", step}, {"end", hashText(stateHash)}}.dump() + "\n");
    file_.commit();
}

LoggedChanges readChanges(const std::string& path, uint64_t world)
{
    std::ifstream file(path);
    if (!file) throw InputError(fmt::format("{}: cannot be read; name a file that --log has written", path));
    LoggedChanges logged;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        // What a killed program could not write to its end.
        if (file.eof() && number > 1) break;
        const auto fail = [&](const std::string& why) {
            throw InputError(fmt::format("{}:{}: {}", path, number, why));
        };
        try {
            const Json json = parseJson(line, "line");
            if (number == 1) {
                if (json.value("format", "") != FORMAT)
                    fail("is no log of changes; name a file that --log has written");
                if (json.at("world").get<std::string>() != hashText(world))
                    fail(fmt::format("is of another world, of the scene {}; give the same scene and --set",
                                     json.at("scene").get<std::string>()));
            } else readLine(json, logged);
        } catch (const Json::exception& error) {
            fail(fmt::format("cannot be read: {}", error.what()));
        } catch (const InputError& error) {
            if (std::string(error.what()).starts_with(path + ":")) throw;
            fail(error.what());
        }
    }
    return logged;
}

}  // namespace knuckle
