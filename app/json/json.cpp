#include "app/json/json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>
#include <sstream>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr uintmax_t MAX_FILE_BYTES = uintmax_t{256} << 20;

/// Line and column, from 1, of the byte `offset` of `text`.
std::string placeOf(const std::string& text, size_t offset)
{
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
    const auto line = 1 + std::count(text.begin(), end, '\n');
    const auto lineStart = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
    return fmt::format("{}:{}", line, std::max<std::ptrdiff_t>(1, end - lineStart));
}

/// The library's message without its position, which our own message contains.
std::string plainMessage(const std::string& what)
{
    const size_t place = what.find(": "), tag = what.find("] ");
    std::string text = place != std::string::npos ? what.substr(place + 2)
                       : tag != std::string::npos ? what.substr(tag + 2)
                                                  : what;
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

size_t editDistance(const std::string& a, const std::string& b)
{
    std::vector<size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (size_t i = 0; i < a.size(); ++i) {
        size_t diagonal = row[0];
        row[0] = i + 1;
        for (size_t j = 0; j < b.size(); ++j) {
            const bool same = std::tolower(a[i]) == std::tolower(b[j]);
            const size_t replaced = diagonal + (same ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j + 1] + 1, row[j] + 1});
        }
    }
    return row.back();
}

}  // namespace

Json parseJson(const std::string& text, const std::string& name)
{
    std::vector<std::set<std::string>> keys;
    const auto rejectTwins = [&](int, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::object_start) {
            keys.emplace_back();
        } else if (event == Json::parse_event_t::object_end) {
            keys.pop_back();
        } else if (event == Json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second) {
            throw InputError(fmt::format("{}: the key \"{}\" stands twice in one object; remove one of them", name,
                                         parsed.get<std::string>()));
        }
        return true;
    };
    try {
        return Json::parse(text, rejectTwins, true, true);
    } catch (const Json::parse_error& error) {
        throw InputError(fmt::format("{}:{}: {}", name, placeOf(text, error.byte), plainMessage(error.what())));
    } catch (const Json::exception& error) {
        throw InputError(fmt::format("{}: {}", name, plainMessage(error.what())));
    }
}

std::string readInput(const std::string& path, const char* kind)
{
    std::error_code failure;
    const auto status = std::filesystem::status(path, failure);
    if (!std::filesystem::exists(status)) throw InputError(fmt::format("{}: there is no such file", path));
    if (std::filesystem::is_directory(status)) throw InputError(fmt::format("{}: is a folder, not a file", path));
    const auto bytes = std::filesystem::file_size(path, failure);
    if (!failure && bytes > MAX_FILE_BYTES) {
        throw InputError(fmt::format("{}: {} MiB is too large for {}, the limit is {} MiB", path, bytes >> 20, kind,
                                     MAX_FILE_BYTES >> 20));
    }
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
    return text.str();
}

JsonFile readJsonFile(const std::string& path)
{
    return {path, parseJson(readInput(path, "a JSON file"), path)};
}

void failAt(const std::string& path, const std::string& pointer, const std::string& message)
{
    throw InputError(fmt::format("{}: {}: {}", path, pointer.empty() ? "/" : pointer, message));
}

std::string nearestWord(const std::string& word, const std::vector<std::string>& candidates)
{
    std::string best;
    size_t bestDistance = std::max<size_t>(2, word.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        const size_t distance = editDistance(word, candidate);
        if (distance < bestDistance && distance < candidate.size()) {
            best = candidate;
            bestDistance = distance;
        }
    }
    return best;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& candidates)
{
    const std::string nearest = nearestWord(word, candidates);
    if (!nearest.empty()) return fmt::format("did you mean \"{}\"?", nearest);
    return candidates.empty() ? "there are none" : fmt::format("known: {}", fmt::join(candidates, ", "));
}

}  // namespace knuckle
