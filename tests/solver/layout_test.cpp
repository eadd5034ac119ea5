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

/// Every member of `block` lies where C++ has it, and there are no others. `prefix` is what GL puts before a name.
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

/// The same of an array of structs, whose stride is the struct's size.
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
                                             MEMBER(StepParameters, calming),
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
                                             MEMBER(StepParameters, solidCover),
                                             MEMBER(StepParameters, inverseFluidCell),
                                             MEMBER(StepParameters, fluidCellMask),
                                             MEMBER(StepParameters, fluidStrideY),
                                             MEMBER(StepParameters, fluidStrideZ),
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
const std::vector<Member> COUNTERS = {MEMBER(Counters, problems),       MEMBER(Counters, wantedCandidates),
                                      MEMBER(Counters, candidateCount), MEMBER(Counters, badParticle),
                                      MEMBER(Counters, substep),        MEMBER(Counters, due),
                                      MEMBER(Counters, listParity),     MEMBER(Counters, searchCount),
                                      MEMBER(Counters, pairCount),      MEMBER(Counters, colliderPairCount),
                                      MEMBER(Counters, wantedPairs),    MEMBER(Counters, wantedColliderPairs),
                                      MEMBER(Counters, fastCount),      MEMBER(Counters, fastListed),
                                      MEMBER(Counters, fastLater),      MEMBER(Counters, heard),
                                      MEMBER(Counters, calm),           MEMBER(Counters, wantedNeighbours)};
const std::vector<Member> COLLIDER = {MEMBER(GpuCollider, size), MEMBER(GpuCollider, friction),
                                      MEMBER(GpuCollider, gridLow), MEMBER(GpuCollider, grid)};
const std::vector<Member> EMITTER = {MEMBER(GpuEmitter, velocity),    MEMBER(GpuEmitter, clock),
                                     MEMBER(GpuEmitter, startStep),   MEMBER(GpuEmitter, layerLimit),
                                     MEMBER(GpuEmitter, firstPoint),  MEMBER(GpuEmitter, pointCount),
                                     MEMBER(GpuEmitter, poolStart),   MEMBER(GpuEmitter, poolCount),
                                     MEMBER(GpuEmitter, takesOldest), MEMBER(GpuEmitter, interval)};
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
const std::vector<Member> ANIMATION = {MEMBER(GpuAnimation, position),  MEMBER(GpuAnimation, rotation),
                                       MEMBER(GpuAnimation, firstPlay), MEMBER(GpuAnimation, playCount),
                                       MEMBER(GpuAnimation, puppet),    MEMBER(GpuAnimation, unused1)};
const std::vector<Member> CLIP_PLAY = {
    MEMBER(GpuClipPlay, firstTurn), MEMBER(GpuClipPlay, firstRoot), MEMBER(GpuClipPlay, keyCount),
    MEMBER(GpuClipPlay, bodyCount), MEMBER(GpuClipPlay, at),        MEMBER(GpuClipPlay, firstKey),
    MEMBER(GpuClipPlay, keyRate),   MEMBER(GpuClipPlay, fade),      MEMBER(GpuClipPlay, loop),
    MEMBER(GpuClipPlay, inPlace),   MEMBER(GpuClipPlay, yaw),       MEMBER(GpuClipPlay, roundYaw),
    MEMBER(GpuClipPlay, shift),     MEMBER(GpuClipPlay, roundShift)};
const std::vector<Member> PUPPET = {
    MEMBER(GpuPuppet, firstBody),    MEMBER(GpuPuppet, bodyCount),     MEMBER(GpuPuppet, firstKey),
    MEMBER(GpuPuppet, keyCount),     MEMBER(GpuPuppet, isHeld),        MEMBER(GpuPuppet, mass),
    MEMBER(GpuPuppet, hitImpulse),   MEMBER(GpuPuppet, hitFalloff),    MEMBER(GpuPuppet, hitHold),
    MEMBER(GpuPuppet, hitRecover),   MEMBER(GpuPuppet, knockDistance), MEMBER(GpuPuppet, knockTime),
    MEMBER(GpuPuppet, catchSubstep), MEMBER(GpuPuppet, catchHere),     MEMBER(GpuPuppet, catchOtherwise),
    MEMBER(GpuPuppet, catchBlend),   MEMBER(GpuPuppet, catchNear),     MEMBER(GpuPuppet, catchWithin),
    MEMBER(GpuPuppet, unused1),      MEMBER(GpuPuppet, unused2)};
const std::vector<Member> JOINT_DRIVE = {MEMBER(GpuJointDrive, axis),           MEMBER(GpuJointDrive, stiffness),
                                         MEMBER(GpuJointDrive, damping),        MEMBER(GpuJointDrive, isGiven),
                                         MEMBER(GpuJointDrive, greatestTorque), MEMBER(GpuJointDrive, body),
                                         MEMBER(GpuJointDrive, joint),          MEMBER(GpuJointDrive, row),
                                         MEMBER(GpuJointDrive, parentRow),      MEMBER(GpuJointDrive, puppet),
                                         MEMBER(GpuJointDrive, unused1),        MEMBER(GpuJointDrive, unused2),
                                         MEMBER(GpuJointDrive, unused3)};
const std::vector<Member> PIN = {
    MEMBER(GpuPin, stiffness), MEMBER(GpuPin, damping), MEMBER(GpuPin, greatestForce), MEMBER(GpuPin, greatestTorque),
    MEMBER(GpuPin, body),      MEMBER(GpuPin, joint),   MEMBER(GpuPin, row),           MEMBER(GpuPin, unused1)};
const std::vector<Member> RELEASE = {
    MEMBER(GpuRelease, firstEntry), MEMBER(GpuRelease, entryEnd),      MEMBER(GpuRelease, firstBody),
    MEMBER(GpuRelease, bodyEnd),    MEMBER(GpuRelease, firstParticle), MEMBER(GpuRelease, particleEnd),
    MEMBER(GpuRelease, impulse),    MEMBER(GpuRelease, region),        MEMBER(GpuRelease, firstLimp),
    MEMBER(GpuRelease, limpEnd),    MEMBER(GpuRelease, unused1),       MEMBER(GpuRelease, unused2)};
const std::vector<Member> BODY_INFO = {MEMBER(BodyInfo, linkStart), MEMBER(BodyInfo, linkCount),
                                       MEMBER(BodyInfo, ownCount), MEMBER(BodyInfo, jointCount)};
const std::vector<Member> MOVER_INFO = {MEMBER(MoverInfo, firstRank), MEMBER(MoverInfo, rankCount),
                                        MEMBER(MoverInfo, assembly), MEMBER(MoverInfo, inverseMass)};
const std::vector<Member> PARTICLE_INFO = {MEMBER(ParticleInfo, body), MEMBER(ParticleInfo, bodyCount),
                                           MEMBER(ParticleInfo, assembly), MEMBER(ParticleInfo, material)};
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
    expectArray(kernel, "Emitters", "emitters", sizeof(gpu::GpuEmitter), EMITTER);
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
    expectArray(kernel, "Animations", "animations", sizeof(gpu::GpuAnimation), ANIMATION);
    expectArray(kernel, "ClipPlays", "clipPlays", sizeof(gpu::GpuClipPlay), CLIP_PLAY);
    const Kernel region = fixture.load("release/release_region");
    expectArray(region, "Releases", "releases", sizeof(gpu::GpuRelease), RELEASE);
}

TEST(Layout, DrivesAreTheHostsStructs)
{
    KernelFixture fixture(drivenWorld());
    expectArray(fixture.load("drive/drive_strength"), "Puppets", "puppets", sizeof(gpu::GpuPuppet), PUPPET);
    expectArray(fixture.load("drive/drive_joint"), "JointDrives", "jointDrives", sizeof(gpu::GpuJointDrive),
                JOINT_DRIVE);
    expectArray(fixture.load("drive/drive_pin"), "Pins", "pins", sizeof(gpu::GpuPin), PIN);
}

TEST(Layout, StructsThatKernelsReadAsTexelsAreTheHostsStructs)
{
    // No kernel declares these as storage stages: this one does.
    std::filesystem::create_directories(shaderFolder().path("sim"));
    shaderFolder().write("sim/test_layout.comp", R"(#include "sim/common/kernel.glsl"
layout(local_size_x = 1) in;
BUFFER(ParticleRigidBodyLink, Links, links);
BUFFER(ParticleInfo, ParticleInfos, infos);
BUFFER(BodyInfo, BodyInfos, bodies);
BUFFER(MoverInfo, MoverInfos, movers);
BUFFER(GpuCollider, ColliderStructs, colliders);
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
    expectArray(kernel, "ParticleInfos", "infos", sizeof(gpu::ParticleInfo), PARTICLE_INFO);
    expectArray(kernel, "BodyInfos", "bodies", sizeof(gpu::BodyInfo), BODY_INFO);
    expectArray(kernel, "MoverInfos", "movers", sizeof(gpu::MoverInfo), MOVER_INFO);
    expectArray(kernel, "ColliderStructs", "colliders", sizeof(gpu::GpuCollider), COLLIDER);
}

}  // namespace knuckle::test
