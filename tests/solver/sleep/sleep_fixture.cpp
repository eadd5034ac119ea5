#include "tests/solver/sleep/sleep_fixture.h"
#include "shared/contact_constants.h"

#include <cmath>

namespace knuckle::test {

namespace {

Settings sleepySettings(bool freezes)
{
    Settings settings;
    if (freezes) settings.freeze = 0.5f;
    else settings.sleepSpeed = 0.02f;
    return settings;
}

}  // namespace

SleepFixture::SleepFixture(bool freezes) : ContactFixture(sleepySettings(freezes))
{
    infos_ = stages.bodies.moverInfo.download();
    setCalms(randomCalms(301));
    setNext(randomCalms(302));
    makePairs();
}

std::vector<gpu::uvec2> SleepFixture::randomCalms(uint32_t seed) const
{
    Random random(seed);
    std::vector<gpu::uvec2> values;
    for (uint32_t a = 0; a < assemblyCount(); ++a) {
        const float kind = random.between(0, 3);
        const auto between = static_cast<uint32_t>(
            random.between(1, kind < 1.5f ? 1.9f : static_cast<float>(calmSteps())));
        const auto island = static_cast<uint32_t>(random.between(0, static_cast<float>(a)));
        values.push_back({kind < 1 ? 0 : kind < 2 ? between : calmSteps(), island});
    }
    return values;
}

void SleepFixture::makePairs()
{
    Random random(303);
    const auto count = static_cast<float>(world.particles.size());
    std::vector<TestContact> list;
    while (list.size() < 1501) {
        TestContact c{.first = static_cast<uint32_t>(random.between(0, 0.999f) * count),
                      .second = static_cast<uint32_t>(random.between(0, 0.999f) * count)};
        if (moverOf[c.first] == moverOf[c.second]) continue;
        const float kind = random.between(0, 3);
        c.impulse.w = kind < 1 ? 0.0f : kind < 2 ? float(ABOUT_TO_ACT) : kind;
        list.push_back(c);
    }
    setPairs(std::move(list));
}

void SleepFixture::setCalms(const std::vector<gpu::uvec2>& values)
{
    calms = values;
    fill(stages.sleep->assemblyCalm, calms);
}

void SleepFixture::setNext(const std::vector<gpu::uvec2>& values)
{
    next = values;
    fill(stages.sleep->assemblyNext, next);
}

void SleepFixture::runSleep(const std::string& name, uint64_t threads, const Defines& more)
{
    Defines defines = more;
    defines.push_back({"SLEEP", "1"});
    run("sleep/" + name, threads, defines);
}

void SleepFixture::expectCalms(const std::vector<gpu::uvec2>& found, const std::vector<gpu::uvec2>& wanted) const
{
    ASSERT_EQ(found.size(), wanted.size());
    for (uint32_t a = 0; a < found.size(); ++a) {
        ASSERT_EQ(found[a].x, wanted[a].x) << "steps of assembly " << a;
        ASSERT_EQ(found[a].y, wanted[a].y) << "island of assembly " << a;
    }
}

}  // namespace knuckle::test
