#include "tests/physics/joint/chain_fixture.h"

#include <algorithm>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

void addChain(WorldBuilder& builder, const ChainSpec& spec)
{
    Material heavy;
    heavy.density = 1000.0f * spec.load;
    const uint32_t material = builder.addMaterial(heavy);
    builder.beginObject("chain");
    for (uint32_t b = 0; b < spec.bodies; ++b) {
        std::vector<Vector3f> places = boxLattice({3, 3, 3}, DIAMETER);
        for (Vector3f& p : places) p += PITCH * static_cast<float>(b) * Vector3f::UnitX();
        const bool last = b + 1 == spec.bodies, fixed = b == 0 || (last && spec.bothEnds);
        const bool isHeavy = last || std::ranges::find(spec.alsoHeavy, b) != spec.alsoHeavy.end();
        builder.addBody("link" + std::to_string(b), places, isHeavy ? material : 0,
                        fixed ? Motion::Fixed : Motion::Dynamic);
    }
    for (uint32_t b = 0; b + 1 < spec.bodies; ++b) {
        JointSpec joint;
        joint.type = spec.type;
        joint.anchor = PITCH * (static_cast<float>(b) + 0.5f) * Vector3f::UnitX();
        joint.strength = spec.strength;
        joint.limits = spec.limits;
        builder.addJoint(b, b + 1, joint);
    }
    builder.endObject({{0, 0, 0}, Quaternionf::FromTwoVectors(Vector3f::UnitX(), spec.along)});
}

World chain(const ChainSpec& spec)
{
    WorldBuilder builder = makeBuilder();
    addChain(builder, spec);
    return builder.build();
}

}  // namespace knuckle::test
