#include "app/states/view_coding.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <span>

#include "sim/base/no_index.h"

namespace knuckle {

namespace {

using Words = std::vector<uint32_t>;

/// Component k of every vector, then component k + 1: neighbours have similar ones.
template <size_t COMPONENTS>
Words toWords(const std::vector<gpu::vec4>& values)
{
    const size_t n = values.size();
    Words words(COMPONENTS * n);
    for (size_t i = 0; i < n; ++i) {
        const std::array<float, 4> v{values[i].x, values[i].y, values[i].z, values[i].w};
        for (size_t k = 0; k < COMPONENTS; ++k) words[k * n + i] = std::bit_cast<uint32_t>(v[k]);
    }
    return words;
}

template <size_t COMPONENTS>
std::vector<gpu::vec4> fromWords(const Words& words)
{
    const size_t n = words.size() / COMPONENTS;
    std::vector<gpu::vec4> values(n);
    for (size_t i = 0; i < n; ++i) {
        std::array<float, 4> v{};
        for (size_t k = 0; k < COMPONENTS; ++k) v[k] = std::bit_cast<float>(words[k * n + i]);
        values[i] = {v[0], v[1], v[2], v[3]};
    }
    return values;
}

Words toWords(const std::vector<float>& values)
{
    Words words;
    for (const float value : values) words.push_back(std::bit_cast<uint32_t>(value));
    return words;
}

std::vector<float> toFloats(const Words& words)
{
    std::vector<float> values;
    for (const uint32_t word : words) values.push_back(std::bit_cast<float>(word));
    return values;
}

Words bitsOf(size_t count, const auto& isSet)
{
    Words words((count + 31) / 32);
    for (size_t i = 0; i < count; ++i) words[i / 32] |= static_cast<uint32_t>(isSet(i)) << (i % 32);
    return words;
}

bool bitOf(const Words& words, size_t i)
{
    return (words[i / 32] >> (i % 32) & 1u) != 0;
}

/// Floats in the order of their values, as numbers: neighbours differ by one.
uint32_t ordered(float value)
{
    const auto bits = std::bit_cast<uint32_t>(value);
    return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

float fromOrdered(uint32_t order)
{
    return std::bit_cast<float>(order & 0x80000000u ? order & 0x7fffffffu : ~order);
}

/// Small numbers of either sign as small numbers.
uint32_t zigzag(uint32_t difference)
{
    return (difference << 1) ^ (0u - (difference >> 31));
}

uint32_t unzigzag(uint32_t word)
{
    return (word >> 1) ^ (0u - (word & 1u));
}

/// As particle_position.comp computes it, in an order that every reader can repeat.
std::array<float, 3> placeOf(const gpu::vec4& centre, const gpu::vec4& q, const Vector3f& arm)
{
    const std::array<float, 3> t{2.0f * (q.y * arm.z() - q.z * arm.y()), 2.0f * (q.z * arm.x() - q.x * arm.z()),
                                 2.0f * (q.x * arm.y() - q.y * arm.x())};
    return {centre.x + (arm.x() + q.w * t[0] + (q.y * t[2] - q.z * t[1])),
            centre.y + (arm.y() + q.w * t[1] + (q.z * t[0] - q.x * t[2])),
            centre.z + (arm.z() + q.w * t[2] + (q.x * t[1] - q.y * t[0]))};
}

std::string packWords(uint64_t frame, const char* part, const Words& words)
{
    return packArray(frameBlock(frame, part), std::span<const uint32_t>(words));
}

}  // namespace

std::string frameBlock(uint64_t frame, const char* part)
{
    return fmt::format("frame {}/{}", frame, part);
}

ViewCoding::ViewCoding(const World& world)
    : particles_(world.particles.size()), bodies_(world.bodies.size()), colliders_(world.colliders.size()),
      owners_(world.particles.size(), NO_INDEX), arms_(world.particles.size(), Vector3f::Zero())
{
    for (size_t p = 0; p < particles_; ++p) owners_[p] = world.particles[p].body;
    for (const Link& link : world.links)
        if (owners_[link.particle] == link.body) arms_[link.particle] = link.restOffset;
}

ViewCoding::ViewCoding(const BlockReader& file, size_t bodies)
    : bodies_(bodies), owners_(file.readArray<uint32_t>("bodies/of"))
{
    particles_ = owners_.size();
    const Words arms = file.readArray<uint32_t>("bodies/arms");
    const auto isWrong = [&](uint32_t owner) { return owner != NO_INDEX && owner >= bodies_; };
    if (arms.size() != 3 * particles_ || std::ranges::any_of(owners_, isWrong))
        file.refuse("its blocks \"bodies/...\" do not fit each other");
    for (size_t p = 0; p < particles_; ++p)
        arms_.emplace_back(std::bit_cast<float>(arms[p]), std::bit_cast<float>(arms[particles_ + p]),
                           std::bit_cast<float>(arms[2 * particles_ + p]));
    for (const BlockReader::Block& block : file.list())
        if (block.name.starts_with("frame ") && block.name.ends_with("/colliders"))
            colliders_ = block.bytes / (8 * sizeof(float));
}

std::vector<std::string> ViewCoding::packBodies() const
{
    Words arms;
    for (int k = 0; k < 3; ++k)
        for (const Vector3f& arm : arms_) arms.push_back(std::bit_cast<uint32_t>(arm[k]));
    return {packArray("bodies/of", std::span<const uint32_t>(owners_)),
            packArray("bodies/arms", std::span<const uint32_t>(arms))};
}

void ViewCoding::predict(const ViewState& view, Words& words, bool forwards) const
{
    for (size_t p = 0; p < particles_; ++p) {
        const uint32_t body = owners_[p];
        if (body == NO_INDEX) continue;
        const std::array<float, 3> place = placeOf(view.bodyCentres[body], view.bodyRotations[body], arms_[p]);
        for (size_t k = 0; k < 3; ++k) {
            uint32_t& word = words[k * particles_ + p];
            const uint32_t said = ordered(place[k]);
            word = forwards ? zigzag(ordered(std::bit_cast<float>(word)) - said)
                            : std::bit_cast<uint32_t>(fromOrdered(said + unzigzag(word)));
        }
    }
}

std::vector<std::string> ViewCoding::pack(uint64_t frame, const ViewState& view) const
{
    Words positions = toWords<3>(view.positions);
    predict(view, positions, true);
    std::vector<std::string> blocks{packWords(frame, "centres", toWords<3>(view.bodyCentres)),
                                    packWords(frame, "rotations", toWords<4>(view.bodyRotations)),
                                    packWords(frame, "colliders", toWords<4>(view.colliderPlaces)),
                                    packWords(frame, "positions", positions),
                                    packWords(frame, "velocities", toWords<3>(view.velocities))};
    const auto isInactive = [&](size_t p) { return view.positions[p].w != 0.0f; };
    blocks.push_back(packWords(frame, "inactive", bitsOf(particles_, isInactive)));
    blocks.push_back(packWords(frame, "torn", bitsOf(view.torn.size(), [&](size_t p) { return view.torn[p]; })));
    if (!view.foamPlaces.empty()) blocks.push_back(packWords(frame, "foam", toWords<4>(view.foamPlaces)));
    if (!view.fluidForms.empty()) blocks.push_back(packWords(frame, "forms", view.fluidForms));
    if (!view.ages.empty()) blocks.push_back(packWords(frame, AGES, toWords(view.ages)));
    if (!view.contactForces.empty()) blocks.push_back(packWords(frame, CONTACT_FORCES, toWords(view.contactForces)));
    if (std::ranges::find(view.tornDistances, true) != view.tornDistances.end())
        blocks.push_back(packWords(frame, "tornDistances",
                                   bitsOf(view.tornDistances.size(), [&](size_t i) { return view.tornDistances[i]; })));
    return blocks;
}

ViewState ViewCoding::unpack(const BlockReader& file, uint64_t frame) const
{
    const auto words = [&](const char* part, size_t wanted) {
        const std::string name = frameBlock(frame, part);
        Words values = file.readArray<uint32_t>(name);
        if (values.size() != wanted)
            file.refuse(fmt::format("\"{}\" has {} words, and the scene has {}; it is of another scene", name,
                                    values.size(), wanted));
        return values;
    };
    ViewState view;
    view.bodyCentres = fromWords<3>(words("centres", 3 * bodies_));
    view.bodyRotations = fromWords<4>(words("rotations", 4 * bodies_));
    view.colliderPlaces = fromWords<4>(words("colliders", 8 * colliders_));
    Words positions = words("positions", 3 * particles_);
    predict(view, positions, false);
    view.positions = fromWords<3>(positions);
    view.velocities = fromWords<3>(words("velocities", 3 * particles_));
    const Words inactive = words("inactive", (particles_ + 31) / 32);
    for (size_t p = 0; p < particles_; ++p) view.positions[p].w = bitOf(inactive, p) ? 1.0f : 0.0f;
    if (file.has(frameBlock(frame, "foam")))
        view.foamPlaces = fromWords<4>(file.readArray<uint32_t>(frameBlock(frame, "foam")));
    if (file.has(frameBlock(frame, "forms"))) view.fluidForms = words("forms", particles_);
    if (file.has(frameBlock(frame, AGES))) view.ages = toFloats(words(AGES, particles_));
    if (file.has(frameBlock(frame, CONTACT_FORCES))) view.contactForces = toFloats(words(CONTACT_FORCES, particles_));
    if (file.has(frameBlock(frame, "tornDistances"))) {
        const Words bits = file.readArray<uint32_t>(frameBlock(frame, "tornDistances"));
        for (size_t i = 0; i < 32 * bits.size(); ++i) view.tornDistances.push_back(bitOf(bits, i));
    }
    const Words torn = file.readArray<uint32_t>(frameBlock(frame, "torn"));
    if (torn.empty()) return view;
    if (torn.size() != (particles_ + 31) / 32) file.refuse("has joints that tear, and the scene has none");
    for (size_t p = 0; p < particles_; ++p) view.torn.push_back(bitOf(torn, p));
    return view;
}

}  // namespace knuckle
