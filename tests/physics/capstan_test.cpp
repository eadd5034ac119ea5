#include <cstdlib>
#include <iostream>
#include <sstream>

#include "tests/physics/capstan_fixture.h"

namespace knuckle::test {

TEST(Capstan, Explore)
{
    std::string line;
    while (std::getline(std::cin, line)) {
        std::istringstream in(line);
        Capstan c;
        int way;
        double seconds;
        in >> way >> c.substeps >> c.friction >> c.left >> c.right >> c.massPerLength >> c.hang >> seconds;
        c.way = Capstan::Way(way);
        try {
            const CapstanRun r = runCapstan(c, seconds);
            const double e = std::exp(c.friction * c.angle());
            const double truth = 0.5 * GRAVITY * (c.left - c.right * e) / (c.left + c.right * e);
            printf("%-40s sunk %.2f%% of d, stretch %.3f%%, gain %.3g J, moved %.5f m (free %.5f: %.4f), first half %.5f\n",
                   line.c_str(), 100 * r.sunk / 0.04, 100 * r.stretched / (2 * c.hang + 0.7), r.gained, r.moved,
                   truth * seconds * seconds, r.moved / (truth * seconds * seconds), r.between);
        } catch (const std::exception& e) {
            printf("%s: %s\n", line.c_str(), e.what());
        }
        fflush(stdout);
    }
}

}  // namespace knuckle::test
