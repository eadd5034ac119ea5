#include "app/bench/bench_run.h"

namespace knuckle {

nlohmann::ordered_json measuresToJson(const Measures& measures, float diameter)
{
    return {{"meanPenetration", measures.meanPenetration / diameter},
            {"worstPenetration", measures.worstPenetration / diameter},
            {"meanJointGap", measures.meanJointGap / diameter},
            {"worstJointGap", measures.worstJointGap / diameter},
            {"worstShapeError", measures.worstShapeError / diameter},
            {"maxSpeed", measures.maxSpeed}};
}

nlohmann::ordered_json runsToJson(const BenchOptions& options, const Gpu& gpu, uint32_t settled,
                                  nlohmann::ordered_json runs)
{
    nlohmann::ordered_json result = {{"benchmark", options.name}, {"device", gpu.device().name},
                                     {"driverThreads", nullptr},  {"steps", options.steps},
                                     {"settledSteps", settled},   {"drawnSteps", options.drawnSteps},
                                     {"runs", std::move(runs)}};
    if (gpu.threads().count) result["driverThreads"] = *gpu.threads().count;
    return result;
}

}  // namespace knuckle
