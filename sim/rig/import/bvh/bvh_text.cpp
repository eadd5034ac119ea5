#include "sim/rig/import/bvh/bvh_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <optional>
#include <set>
#include <string_view>

#include "sim/base/lowercase.h"
#include "sim/rig/anatomy/names/name_pattern.h"
#include "sim/rig/import/import.h"
#include "sim/rig/model_source.h"

namespace knuckle {

namespace {

constexpr std::string_view BYTE_ORDER_MARK = "\xEF\xBB\xBF";
constexpr std::string_view SPACES = " \t\r\n\f\v";
constexpr size_t MOST_CHANNELS = 64;  // of one joint; more is no number of channels

/// Splits a text into words like assimp; braces are words, too.
class Words {
public:
    explicit Words(std::string_view text) : text_(text) {}

    std::string next()
    {
        skipSpaces();
        size_t end = at_;
        while (end < text_.size() && SPACES.find(text_[end]) == std::string_view::npos) {
            const bool isBrace = text_[end] == '{' || text_[end] == '}';
            if (isBrace && end > at_) break;
            ++end;
            if (isBrace) break;
        }
        return taken(end);
    }
    /// The text before the next brace, without the spaces around it.
    std::string upToBrace()
    {
        skipSpaces();
        std::string name = taken(std::min(text_.find_first_of("{}", at_), text_.size()));
        name.erase(name.find_last_not_of(SPACES) + 1);
        return name;
    }
    std::string_view rest() const { return text_.substr(at_); }

private:
    void skipSpaces() { at_ = std::min(text_.find_first_not_of(SPACES, at_), text_.size()); }
    std::string taken(size_t end)
    {
        std::string word(text_.substr(at_, end - at_));
        at_ = end;
        return word;
    }

    std::string_view text_;
    size_t at_ = 0;
};

/// One ROOT with all that hangs on it, in assimp's words.
struct Hierarchy {
    std::string name;  ///< The user's name for it.
    std::string text;
    size_t joints = 0, channels = 0;
};

/// Reads hierarchies; all its functions return nothing for text that is not BVH.
class HierarchyReader {
public:
    explicit HierarchyReader(Words& words) : words_(words) {}

    std::optional<Hierarchy> readRoot()
    {
        Hierarchy root;
        root.name = words_.upToBrace();
        if (const int times = ++roots_[root.name]; times > 1) root.name += fmt::format("#{}", times);
        if (root.name.empty() || !readJoint("ROOT", root.name, root)) return {};
        return root;
    }

    std::map<std::string, std::string> originals;

private:
    bool readJoint(std::string_view keyword, const std::string& name, Hierarchy& root)
    {
        if (name.empty() || words_.next() != "{") return false;
        root.joints += keyword != "End";
        root.text += keyword == "End" ? "End Site\n{\n" : fmt::format("{} {}\n{{\n", keyword, oneWord(name));
        for (std::string word = lowercase(words_.next()); word != "}"; word = lowercase(words_.next())) {
            bool understood = false;
            if (word == "offset") understood = readOffset(root);
            if (word == "channels") understood = readChannels(root);
            if (word == "joint") understood = readJoint("JOINT", words_.upToBrace(), root);
            if (word == "end") understood = readJoint("End", words_.upToBrace(), root);
            if (!understood) return false;
        }
        root.text += "}\n";
        return true;
    }

    bool readOffset(Hierarchy& root)
    {
        const std::string x = words_.next(), y = words_.next(), z = words_.next();
        root.text += fmt::format("OFFSET {} {} {}\n", x, y, z);
        return true;
    }

    bool readChannels(Hierarchy& root)
    {
        const std::string word = words_.next();
        if (word.empty() || word.size() > 2 || word.find_first_not_of("0123456789") != std::string::npos) return false;
        const size_t count = std::stoul(word);
        if (count > MOST_CHANNELS) return false;
        root.text += fmt::format("CHANNELS {}", count);
        for (size_t c = 0; c < count; ++c) {
            std::string channel = lowercase(words_.next());
            if (!channel.empty()) channel[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(channel[0])));
            root.text += " " + channel;
        }
        root.text += "\n";
        root.channels += count;
        return true;
    }

    /// A name without spaces that no other joint has.
    std::string oneWord(const std::string& name)
    {
        std::string word = name;
        for (char& c : word)
            if (SPACES.find(c) != std::string_view::npos) c = '_';
        while (used_.contains(word)) word += "_";
        if (word != name) originals[word] = name;
        used_.insert(word);
        return word;
    }

    Words& words_;
    std::map<std::string, int> roots_;
    std::set<std::string> used_;
};

/// Numbers separated by spaces instead of commas. A comma within a number stays.
std::string withoutCommas(std::string numbers)
{
    for (size_t at = numbers.find(','); at != std::string::npos; at = numbers.find(',', at + 1))
        if (at + 1 == numbers.size() || SPACES.find(numbers[at + 1]) != std::string_view::npos) numbers[at] = ' ';
    return numbers;
}

/// The columns first .. first + count - 1 of a motion of `all` columns, with a header in assimp's spelling.
std::string motion(Words& words, size_t first, size_t count, size_t all)
{
    std::string text = "MOTION\n";
    const std::string frames = words.next(), number = words.next();
    const std::string frame = words.next(), time = words.next(), seconds = words.next();
    const bool isHead = lowercase(frames) == "frames:" && lowercase(frame) == "frame" && lowercase(time) == "time:";
    text += fmt::format("{} {}\n{} {}\n", isHead ? "Frames:" : frames, number,
                        isHead ? "Frame Time:" : frame + " " + time, seconds);
    if (count == all) return text += withoutCommas(std::string(words.rest()));
    size_t column = 0;
    for (std::string word = words.next(); !word.empty(); word = words.next()) {
        if (column >= first && column < first + count) text += withoutCommas(word) + " ";
        column = (column + 1) % all;
        if (column == 0) text += "\n";
    }
    return text;
}

/// All hierarchies as one that hangs on a root without channels.
std::string joinedText(const std::vector<Hierarchy>& roots)
{
    constexpr size_t WORD = std::string_view("ROOT").size();
    std::string text = "ROOT skeletons\n{\nOFFSET 0 0 0\nCHANNELS 0\n";
    for (const Hierarchy& root : roots) text += "JOINT" + root.text.substr(WORD);
    return text + "}\n";
}

/// The index of the requested hierarchy.
size_t pick(const std::vector<Hierarchy>& roots, const std::string& skeleton, std::vector<std::string>& notes)
{
    if (roots.size() == 1) return 0;
    std::vector<std::string> choice;
    for (const Hierarchy& root : roots) choice.push_back(fmt::format("{} ({} bones)", root.name, root.joints));
    if (skeleton.empty())
        throw SkeletonError(fmt::format("it holds {} skeletons: {}", roots.size(), fmt::join(choice, ", ")));
    for (size_t r = 0; r < roots.size(); ++r) {
        if (roots[r].name != skeleton && !matchesPattern(roots[r].name, skeleton)) continue;
        notes.push_back(fmt::format("Of {} skeletons only {} was taken.", roots.size(), roots[r].name));
        return r;
    }
    throw SkeletonError(fmt::format("it has no skeleton '{}', but {}", skeleton, fmt::join(choice, ", ")));
}

}  // namespace

PreparedBvh prepareBvh(std::string text, const std::string& skeleton)
{
    PreparedBvh prepared;
    if (text.starts_with(BYTE_ORDER_MARK)) text.erase(0, BYTE_ORDER_MARK.size());
    prepared.text = text;
    Words words(text);
    if (lowercase(words.next()) != "hierarchy") return prepared;
    HierarchyReader reader(words);
    std::vector<Hierarchy> roots;
    std::string word = lowercase(words.next());
    for (; word == "root"; word = lowercase(words.next())) {
        std::optional<Hierarchy> root = reader.readRoot();
        if (!root) return prepared;
        roots.push_back(std::move(*root));
    }
    if (roots.empty() || (!word.empty() && word != "motion")) return prepared;
    const bool areJoined = roots.size() > 1 && skeleton == ALL_SKELETONS;
    const size_t taken = areJoined ? 0 : pick(roots, skeleton, prepared.notes);
    size_t before = 0, all = 0;
    for (size_t r = 0; r < roots.size(); ++r) {
        if (r < taken) before += roots[r].channels;
        all += roots[r].channels;
    }
    const size_t columns = areJoined ? all : roots[taken].channels;
    prepared.text = "HIERARCHY\n" + (areJoined ? joinedText(roots) : roots[taken].text);
    prepared.text += word == "motion" ? motion(words, before, columns, all)
                                      : "MOTION\nFrames: 0\nFrame Time: 1\n";  // assimp needs one
    prepared.originals = std::move(reader.originals);
    return prepared;
}

}  // namespace knuckle
