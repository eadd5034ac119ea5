#include <algorithm>
#include <numeric>

#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

/// The exclusive prefix sum of the sums of chunks.
std::vector<uint32_t> chunkStarts(const std::vector<uint32_t>& values)
{
    std::vector<uint32_t> starts{0};
    for (size_t k = 0; k < values.size(); k += SCAN_CHUNK) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(k);
        const auto length = static_cast<std::ptrdiff_t>(std::min<size_t>(SCAN_CHUNK, values.size() - k));
        starts.push_back(std::accumulate(first, first + length, starts.back()));
    }
    starts.pop_back();
    return starts;
}

TEST(Scan, ManyGroupsMakeOnePrefixSumAgainAndAgain)
{
    // 1407 chunks, the last one of 19 values, in 22 groups, the last one of 63 chunks; and more chunks than a thread of
    // llvmpipe runs through loops.
    for (const uint32_t particles : {30001u, 1'500'017u}) {
        KernelFixture fixture(mixedWorld());
        fixture.stages.parameters.particleCount = particles;
        fixture.setParameters();
        fixture.stages.search.makeLists();
        Random random(5);
        for (int run = 0; run < (particles > 1e6 ? 1 : 3); ++run) {
            std::vector<uint32_t> values(3 * size_t{particles});
            for (uint32_t& value : values) value = static_cast<uint32_t>(random.between(0.0f, 9.0f));
            fill(fixture.stages.search.listCounts, values);
            const auto expected = chunkStarts(values);
            fixture.run("common/grid/scan_sum", expected.size(), {{"LISTS", "1"}});
            auto sums = fixture.stages.search.listSums.download();
            EXPECT_EQ(sums.back(), 0u) << "how many groups have finished, for the next time";
            sums.pop_back();
            EXPECT_TRUE(sums == expected) << "run " << run << ", " << particles << " particles";
        }
    }
}

}  // namespace

}  // namespace knuckle::test
