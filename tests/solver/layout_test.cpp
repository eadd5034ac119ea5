#include <cstddef>

#include "tests/solver/determinism_worlds.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

struct Member {
    const char* name;
    size_t offset;
};
#define MEMBER(Struct, name)               \
    Member                                 \
    {                                      \
#name, offsetof(gpu::Struct, name) \
    }

GLint property(GLuint program, GLenum interface, GLuint index, GLenum wanted)
{
    GLint value = -1;
    glGetProgramResourceiv(program, interface, index, 1, &wanted, 1, nullptr, &value);
    return value;
}

/// Checks that every member of `block` is where C++ has it, and that there are no others. `prefix` is GL's prefix of
/// names.
void expectMembers(const Kernel& kernel, GLenum blocks, const std::string& block, const std::string& prefix,
                   const std::vector<Member>& members)
{
    const bool storage = blocks == GL_SHADER_STORAGE_BLOCK;
    const GLenum variables = storage ? GL_BUFFER_VARIABLE : GL_UNIFORM;
    const GLuint blockIndex = glGetProgramResourceIndex(kernel.program(), blocks, block.c_str());
    ASSERT_NE(blockIndex, GL_INVALID_INDEX) << block;
    EXPECT_EQ(property(kernel.program(), blocks, blockIndex, GL_NUM_ACTIVE_VARIABLES), GLint(members.size())) << block;
    for (const Member& member : members) {
        const std::string name = prefix + member.name;
        const GLuint index = glGetProgramResourceIndex(kernel.program(), variables, name.c_str());
        ASSERT_NE(index, GL_INVALID_INDEX) << name;
        EXPECT_EQ(property(kernel.program(), variables, index, GL_OFFSET), GLint(member.offset)) << name;
    }
}

/// The same for an array of structs, whose stride is the struct's size.
void expectArray(const Kernel& kernel, const std::string& block, const std::string& name, size_t size,
                 const std::vector<Member>& members)
{
    expectMembers(kernel, GL_SHADER_STORAGE_BLOCK, block, name + "[0].", members);
    const std::string first = name + "[0]." + members[0].name;
    const GLuint index = glGetProgramResourceIndex(kernel.program(), GL_BUFFER_VARIABLE, first.c_str());
    EXPECT_EQ(property(kernel.program(), GL_BUFFER_VARIABLE, index, GL_TOP_LEVEL_ARRAY_STRIDE), GLint(size)) << block;
}

const std::vector<Member> STEP_PARAMETERS = {MEMBER(StepParameters, gravity),
                                             MEMBER(StepParameters, wind),
                                             MEMBER(StepParameters, forceFieldCount),
                                             MEMBER(StepParameters, gustWaveCount),
                                             MEMBER(StepParameters, dropDrag),
                                             MEMBER(StepParameters, particleCount),
                                             MEMBER(StepParameters, bodyCount),
                                             MEMBER(StepParameters, freeBodyCount),
                                             MEMBER(StepParameters, jointedBodyCount),
                                             MEMBER(StepParameters, releaseCount),
                                             MEMBER(StepParameters, impulseWatchCount),
                                             MEMBER(StepParameters, touchWatchCount),
                                             MEMBER(StepParameters, regionWatchCount),
                                             MEMBER(StepParameters, animatedCount),
                                             MEMBER(StepParameters, puppetCount),
                                             MEMBER(StepParameters, jointDriveCount),
                                             MEMBER(StepParameters, pinCount),
                                             MEMBER(StepParameters, motorCount),
                                             MEMBER(StepParameters, gearTrainCount),
                                             MEMBER(StepParameters, linkCount),
                                             MEMBER(StepParameters, colliderCount),
                                             MEMBER(StepParameters, movingColliderCount),
                                             MEMBER(StepParameters, candidateCapacity),
                                             MEMBER(StepParameters, cellMask),
                                             MEMBER(StepParameters, cellStrideY),
                                             MEMBER(StepParameters, cellStrideZ),
                                             MEMBER(StepParameters, diameter),
                                             MEMBER(StepParameters, contactReach),
                                             MEMBER(StepParameters, plainReach),
                                             MEMBER(StepParameters, inverseCellSize),
                                             MEMBER(StepParameters, drift),
                                             MEMBER(StepParameters, substepTime),
                                             MEMBER(StepParameters, correction),
                                             MEMBER(StepParameters, warmStart),
                                             MEMBER(StepParameters, impulseDamping),
                                             MEMBER(StepParameters, meanRate),
                                             MEMBER(StepParameters, virtualParticles),
                                             MEMBER(StepParameters, freeze),
                                             MEMBER(StepParameters, damping),
                                             MEMBER(StepParameters, maxSpeed),
                                             MEMBER(StepParameters, secondOrder),
                                             MEMBER(StepParameters, rotationIterations),
                                             MEMBER(StepParameters, maxCorrection),
                                             MEMBER(StepParameters, jointTreeCount),
                                             MEMBER(StepParameters, treeJointCount),
                                             MEMBER(StepParameters, overRelaxation),
                                             MEMBER(StepParameters, stabilization),
                                             MEMBER(StepParameters, deepOverlap),
                                             MEMBER(StepParameters, deepRecovery),
                                             MEMBER(StepParameters, jointCorrection),
                                             MEMBER(StepParameters, sharedCount),
                                             MEMBER(StepParameters, moverCount),
                                             MEMBER(StepParameters, pairCapacity),
                                             MEMBER(StepParameters, colliderPairCapacity),
                                             MEMBER(StepParameters, lookAhead),
                                             MEMBER(StepParameters, farReach),
                                             MEMBER(StepParameters, fastLimit),
                                             MEMBER(StepParameters, horizon),
                                             MEMBER(StepParameters, fluidCount),
                                             MEMBER(StepParameters, fluidSlots),
                                             MEMBER(StepParameters, fluidSpacing),
                                             MEMBER(StepParameters, fluidReach),
                                             MEMBER(StepParameters, fluidListReach),
                                             MEMBER(StepParameters, fluidVolume),
                                             MEMBER(StepParameters, fluidSoftness),
                                             MEMBER(StepParameters, inverseFluidCell),
                                             MEMBER(StepParameters, fluidCellMask),
                                             MEMBER(StepParameters, fluidStrideY),
                                             MEMBER(StepParameters, fluidStrideZ),
                                             MEMBER(StepParameters, foamCapacity),
                                             MEMBER(StepParameters, evenSmoothing),
                                             MEMBER(StepParameters, quietSpeed),
                                             MEMBER(StepParameters, vorticity),
                                             MEMBER(StepParameters, massScaling),
                                             MEMBER(StepParameters, restitutionThreshold),
                                             MEMBER(StepParameters, sleepSpeed),
                                             MEMBER(StepParameters, calmSteps),
                                             MEMBER(StepParameters, assemblyCount),
                                             MEMBER(StepParameters, clusterCount),
                                             MEMBER(StepParameters, softCount),
                                             MEMBER(StepParameters, substeps),
                                             MEMBER(StepParameters, fluidFilled),
                                             MEMBER(StepParameters, poolCapacity),
                                             MEMBER(StepParameters, drainCount)};
const std::vector<Member> COUNTERS = {
    MEMBER(Counters, problems),          MEMBER(Counters, wantedCandidates), MEMBER(Counters, candidateCount),
    MEMBER(Counters, badParticle),       MEMBER(Counters, substep),          MEMBER(Counters, due),
    MEMBER(Counters, listParity),        MEMBER(Counters, searchCount),      MEMBER(Counters, pairCount),
    MEMBER(Counters, colliderPairCount), MEMBER(Counters, wantedPairs),      MEMBER(Counters, wantedColliderPairs),
    MEMBER(Counters, fastCount),         MEMBER(Counters, fastListed),       MEMBER(Counters, fastLater),
    MEMBER(Counters, freeMoved),         MEMBER(Counters, farSighted),       MEMBER(Counters, wantedNeighbours)};
const std::vector<Member> COLLIDER = {MEMBER(Collider, size), MEMBER(Collider, friction), MEMBER(Collider, gridLow),
                                      MEMBER(Collider, grid)};
const std::vector<Member> EMITTER = {
    MEMBER(Emitter, velocity),    MEMBER(Emitter, clock),      MEMBER(Emitter, startStep), MEMBER(Emitter, layerLimit),
    MEMBER(Emitter, firstPoint),  MEMBER(Emitter, pointCount), MEMBER(Emitter, poolStart), MEMBER(Emitter, poolCount),
    MEMBER(Emitter, takesOldest), MEMBER(Emitter, interval)};
const std::vector<Member> EMITTER_STATE = {MEMBER(EmitterState, taken),          MEMBER(EmitterState, retired),
                                           MEMBER(EmitterState, inactive),       MEMBER(EmitterState, age),
                                           MEMBER(EmitterState, firstCandidate), MEMBER(EmitterState, unused0),
                                           MEMBER(EmitterState, unused1),        MEMBER(EmitterState, unused2)};
const std::vector<Member> ANIMATED_BODY = {MEMBER(AnimatedBody, mover),     MEMBER(AnimatedBody, parent),
                                           MEMBER(AnimatedBody, animation), MEMBER(AnimatedBody, turn),
                                           MEMBER(AnimatedBody, centre),    MEMBER(AnimatedBody, anchor)};
const std::vector<Member> MOVING_COLLIDER = {MEMBER(MovingCollider, collider), MEMBER(MovingCollider, animation),
                                             MEMBER(MovingCollider, reach),    MEMBER(MovingCollider, unused0),
                                             MEMBER(MovingCollider, position), MEMBER(MovingCollider, orientation)};
const std::vector<Member> ANIMATION = {MEMBER(Animation, position),  MEMBER(Animation, rotation),
                                       MEMBER(Animation, firstPlay), MEMBER(Animation, playCount),
                                       MEMBER(Animation, puppet),    MEMBER(Animation, unused1)};
const std::vector<Member> CLIP_PLAY = {
    MEMBER(ClipPlay, firstTurn), MEMBER(ClipPlay, firstRoot), MEMBER(ClipPlay, keyCount), MEMBER(ClipPlay, bodyCount),
    MEMBER(ClipPlay, at),        MEMBER(ClipPlay, firstKey),  MEMBER(ClipPlay, keyRate),  MEMBER(ClipPlay, fade),
    MEMBER(ClipPlay, loop),      MEMBER(ClipPlay, inPlace),   MEMBER(ClipPlay, yaw),      MEMBER(ClipPlay, roundYaw),
    MEMBER(ClipPlay, shift),     MEMBER(ClipPlay, roundShift)};
const std::vector<Member> PUPPET = {
    MEMBER(Puppet, firstBody),    MEMBER(Puppet, bodyCount),     MEMBER(Puppet, firstKey),
    MEMBER(Puppet, keyCount),     MEMBER(Puppet, isHeld),        MEMBER(Puppet, mass),
    MEMBER(Puppet, hitImpulse),   MEMBER(Puppet, hitFalloff),    MEMBER(Puppet, hitHold),
    MEMBER(Puppet, hitRecover),   MEMBER(Puppet, knockDistance), MEMBER(Puppet, knockTime),
    MEMBER(Puppet, catchSubstep), MEMBER(Puppet, catchHere),     MEMBER(Puppet, catchOtherwise),
    MEMBER(Puppet, catchBlend),   MEMBER(Puppet, catchNear),     MEMBER(Puppet, catchWithin),
    MEMBER(Puppet, unused1),      MEMBER(Puppet, unused2)};
const std::vector<Member> JOINT_DRIVE = {MEMBER(JointDrive, axis),           MEMBER(JointDrive, stiffness),
                                         MEMBER(JointDrive, damping),        MEMBER(JointDrive, isGiven),
                                         MEMBER(JointDrive, greatestTorque), MEMBER(JointDrive, body),
                                         MEMBER(JointDrive, joint),          MEMBER(JointDrive, row),
                                         MEMBER(JointDrive, parentRow),      MEMBER(JointDrive, puppet),
                                         MEMBER(JointDrive, unused1),        MEMBER(JointDrive, unused2),
                                         MEMBER(JointDrive, unused3)};
const std::vector<Member> PIN = {
    MEMBER(Pin, stiffness), MEMBER(Pin, damping), MEMBER(Pin, greatestForce), MEMBER(Pin, greatestTorque),
    MEMBER(Pin, body),      MEMBER(Pin, joint),   MEMBER(Pin, row),           MEMBER(Pin, unused1)};
const std::vector<Member> RELEASE = {
    MEMBER(Release, firstEntry),    MEMBER(Release, entryEnd),    MEMBER(Release, firstBody), MEMBER(Release, bodyEnd),
    MEMBER(Release, firstParticle), MEMBER(Release, particleEnd), MEMBER(Release, impulse),   MEMBER(Release, region),
    MEMBER(Release, firstLimp),     MEMBER(Release, limpEnd),     MEMBER(Release, unused1),   MEMBER(Release, unused2)};
const std::vector<Member> BODY_INFO = {MEMBER(Body, linkStart), MEMBER(Body, linkCount), MEMBER(Body, ownCount),
                                       MEMBER(Body, jointCount)};
const std::vector<Member> MOVER_INFO = {MEMBER(Mover, firstRank), MEMBER(Mover, rankCount), MEMBER(Mover, assembly),
                                        MEMBER(Mover, inverseMass)};
const std::vector<Member> PARTICLE_INFO = {MEMBER(Particle, body), MEMBER(Particle, bodyCount),
                                           MEMBER(Particle, assembly), MEMBER(Particle, material)};
const std::vector<Member> LINK = {
    MEMBER(ParticleRigidBodyLink, particleIndex),           MEMBER(ParticleRigidBodyLink, rbIndex),
    MEMBER(ParticleRigidBodyLink, posInRigidBodyX),         MEMBER(ParticleRigidBodyLink, posInRigidBodyY),
    MEMBER(ParticleRigidBodyLink, posInRigidBodyZ),         MEMBER(ParticleRigidBodyLink, particleLinksBlockStart),
    MEMBER(ParticleRigidBodyLink, particleLinksBlockCount), MEMBER(ParticleRigidBodyLink, mass)};

}  // namespace

TEST(Layout, TheUniformBlockOfAStepIsTheHostsStruct)
{
    KernelFixture fixture(mixedWorld(byThePaper()));
    expectMembers(fixture.load("paper/predict"), GL_UNIFORM_BLOCK, "Step", "sim.", STEP_PARAMETERS);
}

TEST(Layout, CountersAreTheHostsStruct)
{
    KernelFixture fixture(mixedWorld());
    const Kernel kernel = fixture.load("search/collider_find");
    expectArray(kernel, "CountersBlock", "counters", sizeof(gpu::Counters), COUNTERS);
}

TEST(Layout, EmittersAreTheHostsStructs)
{
    WorldBuilder builder(DIAMETER / 2);
    Material water;
    water.fluid = true;
    const Vector3f place(0, 0, 0);
    builder.addFluid(std::span(&place, 1), {0, 0, 0}, builder.addMaterial(water));
    builder.addDrain(Collider{});
    KernelFixture fixture(builder.build());
    const Kernel kernel = fixture.load("emitter/emitter_update", {{"POOL", "1"}});
    expectArray(kernel, "Emitters", "emitters", sizeof(gpu::Emitter), EMITTER);
    expectArray(kernel, "EmitterStates", "newStates", sizeof(gpu::EmitterState), EMITTER_STATE);
}

TEST(Layout, MovingCollidersAreTheHostsStructs)
{
    KernelFixture fixture(movingWorld());
    const Kernel kernel = fixture.load("animation/collider_move");
    expectArray(kernel, "MovingColliders", "movingColliders", sizeof(gpu::MovingCollider), MOVING_COLLIDER);
}

TEST(Layout, AnimationsAndReleasesAreTheHostsStructs)
{
    KernelFixture fixture(animatedWorld());
    const Kernel kernel = fixture.load("animation/animate");
    expectArray(kernel, "AnimatedBodies", "animatedBodies", sizeof(gpu::AnimatedBody), ANIMATED_BODY);
    expectArray(kernel, "Animations", "animations", sizeof(gpu::Animation), ANIMATION);
    expectArray(kernel, "ClipPlays", "clipPlays", sizeof(gpu::ClipPlay), CLIP_PLAY);
    const Kernel region = fixture.load("release/release_region");
    expectArray(region, "Releases", "releases", sizeof(gpu::Release), RELEASE);
}

TEST(Layout, DrivesAreTheHostsStructs)
{
    KernelFixture fixture(drivenWorld());
    expectArray(fixture.load("drive/drive_strength"), "Puppets", "puppets", sizeof(gpu::Puppet), PUPPET);
    expectArray(fixture.load("drive/drive_joint"), "JointDrives", "jointDrives", sizeof(gpu::JointDrive), JOINT_DRIVE);
    expectArray(fixture.load("drive/drive_pin"), "Pins", "pins", sizeof(gpu::Pin), PIN);
}

TEST(Layout, StructsThatKernelsReadAsTexelsAreTheHostsStructs)
{
    // No kernel declares these as storage stages: this one does.
    std::filesystem::create_directories(shaderFolder().path("sim"));
    shaderFolder().write("sim/test_layout.comp", R"(#include "sim/common/kernel.glsl"
layout(local_size_x = 1) in;
BUFFER(ParticleRigidBodyLink, Links, links);
BUFFER(Particle, ParticleInfos, infos);
BUFFER(Body, BodyInfos, bodies);
BUFFER(Mover, MoverInfos, movers);
BUFFER(Collider, ColliderStructs, colliders);
void main()
{
    links[0].mass = float(infos[0].material + bodies[0].jointCount + movers[0].rankCount + sim.particleCount);
    colliders[0].grid = uvec4(1);
}
)");
    KernelFixture fixture(mixedWorld());
    BufferTable table = fixture.stages.table();
    table.add("particleInfos", fixture.stages.particles.particleInfo,
              elementType<decltype(fixture.stages.particles.particleInfo)::Element>(), Lifetime::Constant);
    table.add("bodyInfos", fixture.stages.bodies.bodyInfo,
              elementType<decltype(fixture.stages.bodies.bodyInfo)::Element>(), Lifetime::Constant);
    table.add("moverInfos", fixture.stages.bodies.moverInfo,
              elementType<decltype(fixture.stages.bodies.moverInfo)::Element>(), Lifetime::Constant);
    table.add("colliderStructs", fixture.stages.colliders.colliders,
              elementType<decltype(fixture.stages.colliders.colliders)::Element>(), Lifetime::Constant);
    const Kernel kernel(gpu(), table, "sim/test_layout.comp");
    expectArray(kernel, "Links", "links", sizeof(gpu::ParticleRigidBodyLink), LINK);
    expectArray(kernel, "ParticleInfos", "infos", sizeof(gpu::Particle), PARTICLE_INFO);
    expectArray(kernel, "BodyInfos", "bodies", sizeof(gpu::Body), BODY_INFO);
    expectArray(kernel, "MoverInfos", "movers", sizeof(gpu::Mover), MOVER_INFO);
    expectArray(kernel, "ColliderStructs", "colliders", sizeof(gpu::Collider), COLLIDER);
}

}  // namespace knuckle::test
