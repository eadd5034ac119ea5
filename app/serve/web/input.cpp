#include "app/serve/web/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/json/json.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr const char* WHERE = "input";

float numberIn(const Json& json, const std::string& field, float lowest, float highest)
{
    const auto found = json.find(field);
    if (found == json.end() || !found->is_number()) failAt(WHERE, "/" + field, "must be a number");
    const auto value = found->get<float>();
    if (!(value >= lowest && value <= highest))
        failAt(WHERE, "/" + field, fmt::format("is {:g}; give one from {:g} to {:g}", value, lowest, highest));
    return value;
}

/// @param most of each number, either way.
template <int N>
Eigen::Matrix<float, N, 1> numbersIn(const Json& json, const std::string& field, float most)
{
    const auto found = json.find(field);
    const bool fits = found != json.end() && found->is_array() && found->size() == N &&
                      std::ranges::all_of(*found, [](const Json& value) { return value.is_number(); });
    if (!fits) failAt(WHERE, "/" + field, fmt::format("must be a list of {} numbers", N));
    Eigen::Matrix<float, N, 1> values;
    for (int k = 0; k < N; ++k) values[k] = found->at(static_cast<size_t>(k)).template get<float>();
    if (!values.allFinite() || values.cwiseAbs().maxCoeff() > most)
        failAt(WHERE, "/" + field, fmt::format("has a number beyond {:g}", most));
    return values;
}

std::string wordIn(const Json& json, const std::string& field, const std::string& need)
{
    const auto found = json.find(field);
    if (found == json.end() || !found->is_string()) failAt(WHERE, "/" + field, need);
    return found->get<std::string>();
}

std::vector<float> valueIn(const Json& json)
{
    constexpr float MOST = 1e6f;
    if (json.contains("value") && json.at("value").is_number()) return {numberIn(json, "value", -MOST, MOST)};
    const Eigen::Vector3f vector = numbersIn<3>(json, "value", MOST);
    return {vector.x(), vector.y(), vector.z()};
}

std::vector<std::string> setsIn(const Json& json)
{
    constexpr size_t MOST = 64;
    const auto found = json.find("set");
    const bool fits = found != json.end() && found->is_array() && found->size() <= MOST &&
                      std::ranges::all_of(*found, [](const Json& set) { return set.is_string(); });
    if (!fits) failAt(WHERE, "/set", "must be a list of changes, such as [\"solver.substeps=8\"]");
    return found->get<std::vector<std::string>>();
}

InputKind kindOf(const Json& json)
{
    const auto found = json.find("do");
    if (found == json.end() || !found->is_string()) failAt(WHERE, "/do", "must be a word, such as \"pause\"");
    const auto word = found->get<std::string>();
    const auto known = std::ranges::find(Input::WORDS, word);
    if (known == Input::WORDS.end())
        failAt(WHERE, "/do",
               fmt::format("\"{}\" is unknown; {}", word,
                           suggestion(word, std::vector<std::string>(Input::WORDS.begin(), Input::WORDS.end()))));
    return static_cast<InputKind>(known - Input::WORDS.begin());
}

}  // namespace

Input parseInput(const std::string& text)
{
    const Json json = parseJson(text, WHERE);
    if (!json.is_object()) failAt(WHERE, "", "must be an object, such as {\"do\": \"pause\"}");
    Input input{.kind = kindOf(json)};
    if (input.kind == InputKind::Orbit || input.kind == InputKind::Pan) input.by = numbersIn<2>(json, "by", 10.0f);
    if (input.kind == InputKind::Zoom) input.factor = numberIn(json, "factor", 0.1f, 10.0f);
    if (input.kind == InputKind::Share) input.factor = numberIn(json, "part", 0.01f, 1.0f);
    if (input.kind == InputKind::Speed) input.factor = numberIn(json, "factor", 0.1f, 1.0f);
    if (input.points()) input.at = numbersIn<2>(json, "at", 1.0f).cwiseMax(0.0f);
    if (input.kind == InputKind::Throw || input.kind == InputKind::Ball)
        input.factor = numberIn(json, "speed", 0.1f, 50.0f);
    if (input.kind == InputKind::Push || input.kind == InputKind::Release)
        input.name = wordIn(json, "name", "must be the name of an object or a body");
    if (input.kind == InputKind::Set) {
        input.name = wordIn(json, "field", "must be the name of a field, such as \"gravity\"");
        input.value = valueIn(json);
    }
    if (input.kind == InputKind::Restart) input.sets = setsIn(json);
    if (input.kind == InputKind::Push) {
        input.impulse = numbersIn<3>(json, "impulse", 1e6f);
        if (json.contains("at")) input.place = numbersIn<3>(json, "at", 1e6f);
    }
    if (input.kind == InputKind::Step && json.contains("count"))
        input.count = static_cast<uint32_t>(numberIn(json, "count", 1.0f, 1000.0f));
    return input;
}

}  // namespace knuckle
