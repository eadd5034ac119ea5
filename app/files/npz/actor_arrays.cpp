#include "app/files/npz/actor_arrays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "app/files/npz/actor_fields.h"
#include "app/files/npz/npy.h"

namespace knuckle {

namespace {

using Shape = std::vector<size_t>;

/// All values of an array, by rows.
struct Values {
    std::vector<double> numbers;
    std::vector<std::string> words;

    void add(const Json& json)
    {
        if (json.is_array())
            for (const Json& part : json) add(part);
        else if (json.is_string()) words.push_back(json);
        else numbers.push_back(json.is_boolean() ? (json.get<bool>() ? 1.0 : 0.0) : json.get<double>());
    }
    template <typename T>
    std::vector<T> as() const
    {
        std::vector<T> all;
        for (const double number : numbers) all.push_back(static_cast<T>(number));
        return all;
    }
};

std::string fileOf(ActorValue value, const Shape& shape, const Values& values)
{
    switch (value) {
        case ActorValue::Float: return npyOf(shape, values.as<float>());
        case ActorValue::Double: return npyOf(shape, values.numbers);
        case ActorValue::Integer: return npyOf(shape, values.as<int32_t>());
        case ActorValue::Flag: return npyOf(shape, values.as<bool>());
        case ActorValue::Word: break;
    }
    return npyOf(shape, values.words);
}

/// Those of all entries of a group one after the other; of lists also where each begins.
void addOfGroup(const ActorField& field, const Json& rows, ZipEntries& arrays)
{
    const Json::json_pointer place(field.pointer());
    Values values;
    std::vector<int32_t> starts{0};
    for (const Json& row : rows) {
        if (!row.contains(place)) return;
        values.add(row[place]);
        starts.push_back(starts.back() + static_cast<int32_t>(row[place].size()));
    }
    Shape shape = field.shape;
    if (field.isList()) shape[0] = static_cast<size_t>(starts.back());
    else shape.insert(shape.begin(), rows.size());
    arrays.emplace_back(field.name, fileOf(field.value, shape, values));
    if (field.isList()) arrays.emplace_back(field.list(), npyOf({starts.size()}, starts));
}

/// Arrays by their names, of those that are known.
class Arrays {
public:
    Arrays(const ZipEntries& entries, std::string path) : path_(std::move(path))
    {
        std::vector<std::string> known;
        for (const ActorField& field : actorFields()) {
            known.push_back(field.name);
            if (field.isList()) known.push_back(field.list());
        }
        for (const auto& [file, bytes] : entries) {
            const std::string name = file.ends_with(".npy") ? file.substr(0, file.size() - 4) : file;
            if (std::ranges::count(known, name) == 0)
                failAt(path_, "/" + name, "unknown array; " + suggestion(name, known));
            arrays_[name] = readNpy(bytes, path_, "/" + name);
        }
    }

    const NpyArray* find(const std::string& name) const
    {
        const auto found = arrays_.find(name);
        return found == arrays_.end() ? nullptr : &found->second;
    }
    /// Of a shape in which ANY is any length, and of words or numbers. Nothing if it is not there.
    const NpyArray* find(const std::string& name, const Shape& shape, bool isText) const
    {
        const NpyArray* array = find(name);
        if (!array) return nullptr;
        const auto fits = [](size_t wanted, size_t given) { return wanted == ANY || wanted == given; };
        if (!std::ranges::equal(shape, array->shape, fits))
            fail(name, fmt::format("has the shape {}, must have {}", shapeText(array->shape), wantedText(shape)));
        const bool hasAny = !array->texts.empty() || !array->numbers.empty();
        if (hasAny && array->isText != isText)
            fail(name, isText ? "is of numbers, must be of texts" : "is of texts, must be of numbers");
        for (size_t i = 0; i < array->numbers.size(); ++i)
            if (!std::isfinite(array->numbers[i]))
                fail(name, fmt::format("has {} in row {}; must be finite", array->numbers[i],
                                       array->shape.empty() ? 0 : i * array->shape[0] / array->numbers.size()));
        return array;
    }
    [[noreturn]] void fail(const std::string& name, const std::string& what) const { failAt(path_, "/" + name, what); }

private:
    static std::string wantedText(const Shape& shape)
    {
        if (shape.empty() || shape[0] != ANY) return shapeText(shape);
        std::string text = "(n,";
        for (const size_t extent : std::span(shape).subspan(1)) text += fmt::format(" {},", extent);
        if (shape.size() > 1) text.pop_back();
        return text + ")";
    }
    std::string path_;
    std::map<std::string, NpyArray> arrays_;
};

Json valueAt(ActorValue value, const NpyArray& array, size_t index)
{
    if (array.isText) return array.texts[index];
    const double number = array.numbers[index];
    if (value == ActorValue::Flag) return number != 0.0;
    if (value == ActorValue::Integer && std::nearbyint(number) == number && std::abs(number) < 1e15)
        return static_cast<int64_t>(number);
    return number;
}

/// The values from `at` on, which it moves, in lists of lists as the rest of the shape says.
Json listed(ActorValue value, const NpyArray& array, std::span<const size_t> shape, size_t& at)
{
    if (shape.empty()) return valueAt(value, array, at++);
    Json list = Json::array();
    for (size_t i = 0; i < shape[0]; ++i) list.push_back(listed(value, array, shape.subspan(1), at));
    return list;
}

/// Where each list begins, and the end of the last.
std::vector<size_t> startsOf(const Arrays& arrays, const ActorField& field, size_t rows, size_t end)
{
    const NpyArray* given = arrays.find(field.list(), {rows + 1}, false);
    if (!given)
        arrays.fail(field.list(), fmt::format("is missing: where each list in {} begins, and the end", field.name));
    std::vector<size_t> starts;
    double last = 0.0;
    for (const double start : given->numbers) {
        const bool isFirst = starts.empty();
        if (start < last || (isFirst && start != 0.0) || start > static_cast<double>(end) || std::floor(start) != start)
            arrays.fail(field.list(), fmt::format("has {} in row {}; must rise from 0 to {}, the length of {}", start,
                                                  starts.size(), end, field.name));
        last = start;
        starts.push_back(static_cast<size_t>(start));
    }
    if (starts.back() != end)
        arrays.fail(field.list(),
                    fmt::format("ends with {}; must end with {}, the length of {}", last, end, field.name));
    return starts;
}

void readWhole(const Arrays& arrays, const ActorField& field, Json& document)
{
    const NpyArray* array = arrays.find(field.name, field.shape, field.value == ActorValue::Word);
    if (!array) return;
    size_t at = 0;
    document[Json::json_pointer(field.pointer())] = listed(field.value, *array, array->shape, at);
}

void readRows(const Arrays& arrays, const ActorField& field, Json& rows)
{
    Shape shape = field.shape;
    if (!field.isList()) shape.insert(shape.begin(), rows.size());
    const NpyArray* array = arrays.find(field.name, shape, field.value == ActorValue::Word);
    if (!array) return;
    const Json::json_pointer place(field.pointer());
    std::vector<size_t> starts;
    if (field.isList()) starts = startsOf(arrays, field, rows.size(), array->shape[0]);
    size_t at = 0;
    for (size_t row = 0; row < rows.size(); ++row) {
        Shape own = field.shape;
        if (field.isList()) own[0] = starts[row + 1] - starts[row];
        rows[row][place] = listed(field.value, *array, own, at);
    }
}

/// As many objects as the first array of the group that is there has entries; null if there is none.
Json rowsOf(const Arrays& arrays, const std::string& group)
{
    for (const ActorField& field : actorFields()) {
        if (field.group != group || field.isList()) continue;
        const NpyArray* array = arrays.find(field.name);
        if (!array || array->shape.empty()) continue;
        const bool hasAny = !array->texts.empty() || !array->numbers.empty();
        return Json(hasAny ? array->shape[0] : 0, Json::object());
    }
    return {};
}

}  // namespace

ZipEntries arraysOf(const Json& document)
{
    ZipEntries arrays;
    for (const ActorField& field : actorFields()) {
        const Json::json_pointer place(field.pointer());
        if (*field.group != '\0') {
            addOfGroup(field, document[field.group], arrays);
        } else if (document.contains(place)) {
            Values values;
            values.add(document[place]);
            Shape shape = field.shape;
            if (!shape.empty()) shape[0] = document[place].size();
            arrays.emplace_back(field.name, fileOf(field.value, shape, values));
        }
    }
    for (auto& [name, bytes] : arrays) name += ".npy";
    return arrays;
}

Json documentOf(const ZipEntries& entries, const std::string& path)
{
    const Arrays arrays(entries, path);
    Json document = Json::object();
    for (const char* group : {"bodies", "joints"})
        if (Json rows = rowsOf(arrays, group); rows.is_array()) document[group] = std::move(rows);
    for (const ActorField& field : actorFields()) {
        if (*field.group == '\0') readWhole(arrays, field, document);
        else if (document.contains(field.group)) readRows(arrays, field, document[field.group]);
        else if (arrays.find(field.name))
            arrays.fail(field.name, fmt::format("is given without {}_name; add that", field.group));
    }
    return document;
}

}  // namespace knuckle
