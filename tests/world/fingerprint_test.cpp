#include "sim/world/fingerprint.h"

#include <map>

#include "sim/base/fnv_hash.h"
#include "tests/world/world_fields.h"
#include "tests/world/world_fixture.h"

namespace knuckle::test {

namespace {

const std::vector<Field>& fields()
{
    static const std::vector<Field> LIST{FIELD(particleRadius),
                                         FIELD(assemblyCount),
                                         FIELD(fluidSpacing),
                                         FIELD(fluidCount),
                                         // Lists themselves.
                                         FIELD(materials),
                                         FIELD(particles),
                                         FIELD(bodies),
                                         FIELD(links),
                                         FIELD(joints),
                                         FIELD(objects),
                                         FIELD(clips),
                                         FIELD(animations),
                                         FIELD(puppets),
                                         FIELD(releases),
                                         FIELD(colliders),
                                         FIELD(colliderMotions),
                                         FIELD(softBodies),
                                         FIELD(clusters),
                                         FIELD(clusterLinks),
                                         FIELD(strands),
                                         FIELD(colliderGrids),
                                         FIELD(emitters),
                                         FIELD(drains),
                                         FIELD(clothTriangles),
                                         FIELD(forceFields),
                                         FIELD(settings.solver),
                                         FIELD(settings.rotation),
                                         FIELD(settings.grid),
                                         FIELD(settings.reduction),
                                         FIELD(settings.velocityOrder),
                                         FIELD(settings.gravity.x()),
                                         FIELD(settings.gravity.y()),
                                         FIELD(settings.gravity.z()),
                                         FIELD(settings.timeStep),
                                         FIELD(settings.substeps),
                                         FIELD(settings.iterations),
                                         FIELD(settings.stabilization),
                                         FIELD(settings.contactMargin),
                                         FIELD(settings.freeze),
                                         FIELD(settings.virtualParticles),
                                         FIELD(settings.splitSharedMass),
                                         FIELD(settings.linearDamping),
                                         FIELD(settings.maxSpeed),
                                         FIELD(settings.massScaling),
                                         FIELD(settings.vorticity),
                                         FIELD(settings.sleepSpeed),
                                         FIELD(materials[0].density),
                                         FIELD(materials[0].staticFriction),
                                         FIELD(materials[0].kineticFriction),
                                         FIELD(materials[0].restitution),
                                         FIELD(materials[0].rollingFriction),
                                         FIELD(materials[0].fluid),
                                         FIELD(materials[0].viscosity),
                                         FIELD(materials[0].surfaceTension),
                                         FIELD(materials[0].elasticity.stiffness),
                                         FIELD(materials[0].elasticity.poissonRatio),
                                         FIELD(materials[0].elasticity.damping),
                                         FIELD(materials[0].elasticity.yield),
                                         FIELD(materials[0].elasticity.creep),
                                         FIELD(materials[0].elasticity.maxDeformation),
                                         FIELD(particles[0].position.x()),
                                         FIELD(particles[0].velocity.y()),
                                         FIELD(particles[0].mass),
                                         FIELD(particles[0].material),
                                         FIELD(particles[0].body),
                                         FIELD(particles[0].bodyCount),
                                         FIELD(particles[0].assembly),
                                         FIELD(particles[0].restPosition.z()),
                                         FIELD(particles[0].touchesAssembly),
                                         FIELD(particles[0].selfMargin),
                                         FIELD(particles[0].pinned),
                                         FIELD(particles[0].surface.distance),
                                         FIELD(particles[0].surface.outward.x()),
                                         FIELD(particles[0].surface.ends),
                                         FIELD(bodies[0].motion),
                                         FIELD(bodies[0].releaseTime),
                                         FIELD(bodies[0].watched),
                                         FIELD(bodies[0].material),
                                         FIELD(bodies[0].assembly),
                                         FIELD(bodies[0].linkStart),
                                         FIELD(bodies[0].linkCount),
                                         FIELD(bodies[0].object),
                                         FIELD(bodies[0].round.radius),
                                         FIELD(bodies[0].round.halfHeight),
                                         FIELD(bodies[0].isCross),
                                         FIELD(bodies[0].passes),
                                         FIELD(bodies[0].mass),
                                         FIELD(bodies[0].restCentre.x()),
                                         FIELD(bodies[0].position.x()),
                                         FIELD(bodies[0].rotation.w()),
                                         FIELD(links[0].particle),
                                         FIELD(links[0].body),
                                         FIELD(links[0].restOffset.x()),
                                         FIELD(links[0].mass),
                                         FIELD(joints[0].type),
                                         FIELD(joints[0].parent),
                                         FIELD(joints[0].child),
                                         FIELD(joints[0].particles),
                                         FIELD(joints[0].parentSide.arm.x()),
                                         FIELD(joints[0].parentSide.frame.x()),
                                         FIELD(joints[0].childSide.arm.x()),
                                         FIELD(joints[0].childSide.frame.x()),
                                         FIELD(joints[0].limits.swing),
                                         FIELD(joints[0].limits.twist.lowest),
                                         FIELD(joints[0].limits.twist.highest),
                                         FIELD(joints[0].limits.stiffness),
                                         FIELD(joints[0].strength.force),
                                         FIELD(joints[0].strength.torque),
                                         FIELD(objects[0].bodyStart),
                                         FIELD(objects[0].bodyCount),
                                         FIELD(clips[0].rate),
                                         FIELD(clips[0].bodyCount),
                                         FIELD(clips[0].roots),
                                         FIELD(clips[0].roots[0].z()),
                                         FIELD(clips[0].turns),
                                         FIELD(clips[0].turns[0].w()),
                                         FIELD(animations[0].object),
                                         FIELD(animations[0].pose.translation.x()),
                                         FIELD(animations[0].pose.rotation.w()),
                                         FIELD(animations[0].pivot.x()),
                                         FIELD(animations[0].plays),
                                         FIELD(animations[0].plays[0].clip),
                                         FIELD(animations[0].plays[0].at),
                                         FIELD(animations[0].plays[0].start),
                                         FIELD(animations[0].plays[0].speed),
                                         FIELD(animations[0].plays[0].fade),
                                         FIELD(animations[0].plays[0].loop),
                                         FIELD(animations[0].plays[0].inPlace),
                                         FIELD(puppets[0].animation),
                                         FIELD(puppets[0].joints),
                                         FIELD(puppets[0].joints[0].frequency),
                                         FIELD(puppets[0].joints[0].dampingRatio),
                                         FIELD(puppets[0].joints[0].stiffness),
                                         FIELD(puppets[0].joints[0].damping),
                                         FIELD(puppets[0].joints[0].greatestTorque),
                                         FIELD(puppets[0].joints[0].greatestForce),
                                         FIELD(puppets[0].limpTimes),
                                         FIELD(puppets[0].pins),
                                         FIELD(puppets[0].pins[0].body),
                                         FIELD(puppets[0].pins[0].spring.frequency),
                                         FIELD(puppets[0].strength),
                                         FIELD(puppets[0].strength[0].time),
                                         FIELD(puppets[0].strength[0].value),
                                         FIELD(puppets[0].strength[0].smooth),
                                         FIELD(puppets[0].hit.impulse),
                                         FIELD(puppets[0].hit.falloff),
                                         FIELD(puppets[0].hit.hold),
                                         FIELD(puppets[0].hit.recover),
                                         FIELD(puppets[0].knockOut.distance),
                                         FIELD(puppets[0].knockOut.torqueTime),
                                         FIELD(puppets[0].caught->time),
                                         FIELD(puppets[0].caught->blend),
                                         FIELD(puppets[0].caught->near),
                                         FIELD(puppets[0].caught->within),
                                         FIELD(puppets[0].caught->otherwise),
                                         FIELD(puppets[0].caught->here),
                                         FIELD(puppets[0].caught->releaseTimes),
                                         FIELD(puppets[0].caught->limpTimes),
                                         FIELD(releases[0].cause),
                                         FIELD(releases[0].bodies),
                                         FIELD(releases[0].impulse),
                                         FIELD(releases[0].firstParticle),
                                         FIELD(releases[0].endParticle),
                                         FIELD(releases[0].driven),
                                         FIELD(releases[0].region.radius),
                                         FIELD(colliders[0].shape),
                                         FIELD(colliders[0].position.x()),
                                         FIELD(colliders[0].orientation.w()),
                                         FIELD(colliders[0].halfExtents.x()),
                                         FIELD(colliders[0].radius),
                                         FIELD(colliders[0].halfHeight),
                                         FIELD(colliders[0].grid),
                                         FIELD(colliders[0].staticFriction),
                                         FIELD(colliders[0].kineticFriction),
                                         FIELD(colliderMotions[0].firstCollider),
                                         FIELD(colliderMotions[0].places),
                                         FIELD(colliderMotions[0].places[0].translation.x()),
                                         FIELD(colliderMotions[0].pose.translation.x()),
                                         FIELD(colliderMotions[0].play.speed),
                                         FIELD(softBodies[0].material),
                                         FIELD(softBodies[0].object),
                                         FIELD(softBodies[0].assembly),
                                         FIELD(softBodies[0].rotation.w()),
                                         FIELD(softBodies[0].particleStart),
                                         FIELD(softBodies[0].particleCount),
                                         FIELD(softBodies[0].clusterStart),
                                         FIELD(softBodies[0].clusterCount),
                                         FIELD(clusters[0].softBody),
                                         FIELD(clusters[0].linkStart),
                                         FIELD(clusters[0].linkCount),
                                         FIELD(clusterLinks[0].mass),
                                         FIELD(strands[0].kind),
                                         FIELD(strands[0].particles),
                                         FIELD(strands[0].restLengths),
                                         FIELD(strands[0].compliance),
                                         FIELD(strands[0].tearForce),
                                         FIELD(colliderGrids[0].low.x()),
                                         FIELD(colliderGrids[0].cell.x()),
                                         FIELD(colliderGrids[0].counts.x()),
                                         FIELD(colliderGrids[0].values),
                                         FIELD(colliderGrids[0].drawnLow.x()),
                                         FIELD(colliderGrids[0].drawnHigh.x()),
                                         FIELD(emitters[0].material),
                                         FIELD(emitters[0].nozzle.points),
                                         FIELD(emitters[0].nozzle.pitch),
                                         FIELD(emitters[0].nozzle.layerSpacing),
                                         FIELD(emitters[0].velocity.x()),
                                         FIELD(emitters[0].start),
                                         FIELD(emitters[0].stop),
                                         FIELD(emitters[0].pool),
                                         FIELD(emitters[0].takesOldest),
                                         FIELD(drains[0].radius),
                                         FIELD(clothTriangles[0][2]),
                                         FIELD(wind->velocity.z()),
                                         FIELD(wind->density),
                                         FIELD(wind->gusts),
                                         FIELD(wind->gustSize),
                                         FIELD(wind->seed),
                                         FIELD(forceFields[0].kind),
                                         FIELD(forceFields[0].falloff),
                                         FIELD(forceFields[0].region.radius),
                                         FIELD(forceFields[0].strength),
                                         FIELD(forceFields[0].start),
                                         FIELD(forceFields[0].stop),
                                         {"wind", [](World& w) { w.wind.reset(); }},
                                         {"caught", [](World& w) { w.puppets[0].caught.reset(); }}};
    return LIST;
}

const std::vector<Field>& looks()
{
    static const std::vector<Field> LIST{FIELD(materials[0].name),
                                         FIELD(materials[0].color.x()),
                                         FIELD(bodies[0].name),
                                         FIELD(joints[0].name),
                                         FIELD(objects[0].name),
                                         FIELD(clips[0].name),
                                         FIELD(softBodies[0].name),
                                         FIELD(colliders[0].color.x()),
                                         FIELD(colliders[0].visible),
                                         FIELD(colliderGrids[0].vertices),
                                         FIELD(colliderGrids[0].triangles),
                                         FIELD(skins)};
    return LIST;
}

}  // namespace

TEST(Fingerprint, ChangesWithEveryFieldThatARunDependsOn)
{
    std::map<uint64_t, std::string> found{{fingerprint(oneOfEverything()), "unchanged"}};
    for (const Field& field : fields()) {
        World world = oneOfEverything();
        field.change(world);
        const auto [at, isNew] = found.emplace(fingerprint(world), field.name);
        EXPECT_TRUE(isNew) << field.name << " is taken for " << at->second;
    }
}

TEST(Fingerprint, DoesNotDependOnNamesAndLooks)
{
    const uint64_t wanted = fingerprint(oneOfEverything());
    for (const Field& field : looks()) {
        World world = oneOfEverything();
        field.change(world);
        EXPECT_EQ(fingerprint(world), wanted) << field.name;
    }
}

TEST(Fingerprint, OfTwoOfAKindIsOne)
{
    EXPECT_EQ(fingerprint(jointedCubes({})), fingerprint(jointedCubes({})));
    EXPECT_NE(fingerprint(jointedCubes({})), fingerprint(jointedCubes({}, {}, Motion::Fixed)));
}

/// By the value that is published for "foobar".
TEST(FnvHash, TakesWordsFromTheLeastSignificantByteOn)
{
    FnvHash bytes, words;
    for (const char letter : std::string("foobar")) bytes.add(static_cast<uint8_t>(letter));
    words.add(uint32_t{0x626f6f66});
    words.add(uint16_t{0x7261});
    EXPECT_EQ(bytes.value(), 0x85944171f73967e8u);
    EXPECT_EQ(words.value(), 0x85944171f73967e8u);
}

}  // namespace knuckle::test
