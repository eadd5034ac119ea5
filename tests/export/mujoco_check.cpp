// Loads a figure in MuJoCo and prints what it has read, for test_robot.py, a line for each thing: "body MASS CENTRE
// INERTIA PARENT NAME" and "joint TYPE AXIS LIMITED LOWEST HIGHEST BODY NAME", all in the pose at rest and along the
// world's axes. Then all hinges get a speed [rad/s], and it falls: "run STEPS WARNINGS FALLEN BEYOND", the last two how
// far the mass centre has come down [m] and how far a hinge was beyond its range at worst [rad].
// mujoco_check FILE SECONDS SPEED [through]: its bodies pass through each other
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

void printBodies(const mjModel& model, const mjData& data)
{
    for (int b = 1; b < model.nbody; ++b) {
        const mjtNum* turn = data.ximat + 9 * b;
        const mjtNum* principal = model.body_inertia + 3 * b;
        std::printf("body %.9g", model.body_mass[b]);
        for (int k = 0; k < 3; ++k) std::printf(" %.9g", data.xipos[3 * b + k]);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) {
                double sum = 0.0;
                for (int k = 0; k < 3; ++k) sum += turn[3 * row + k] * principal[k] * turn[3 * column + k];
                std::printf(" %.9g", sum);
            }
        std::printf(" %s %s\n", mj_id2name(&model, mjOBJ_BODY, model.body_parentid[b]),
                    mj_id2name(&model, mjOBJ_BODY, b));
    }
}

void printJoints(const mjModel& model, const mjData& data)
{
    constexpr std::array KINDS{"free", "ball", "slide", "hinge"};
    for (int j = 0; j < model.njnt; ++j) {
        const mjtNum* axis = data.xaxis + 3 * j;
        const char* name = mj_id2name(&model, mjOBJ_JOINT, j);
        std::printf("joint %s %.9g %.9g %.9g %d %.9g %.9g %s %s\n", KINDS.at(model.jnt_type[j]), axis[0], axis[1],
                    axis[2], model.jnt_limited[j], model.jnt_range[2 * j], model.jnt_range[2 * j + 1],
                    mj_id2name(&model, mjOBJ_BODY, model.jnt_bodyid[j]), name ? name : "-");
    }
}

/// How far the worst of the hinges is beyond its range [rad].
double beyondLimits(const mjModel& model, const mjData& data)
{
    double worst = 0.0;
    for (int j = 0; j < model.njnt; ++j) {
        if (model.jnt_limited[j] == 0 || model.jnt_type[j] != mjJNT_HINGE) continue;
        const double angle = data.qpos[model.jnt_qposadr[j]];
        worst = std::max({worst, model.jnt_range[2 * j] - angle, angle - model.jnt_range[2 * j + 1]});
    }
    return worst;
}

}  // namespace

int main(int count, char** words)
{
    std::array<char, 1000> error{};
    mjModel* model = mj_loadXML(words[1], nullptr, error.data(), static_cast<int>(error.size()));
    if (!model) {
        std::fprintf(stderr, "%s\n", error.data());
        return 1;
    }
    mjData* data = mj_makeData(model);
    mj_forward(model, data);
    printBodies(*model, *data);
    printJoints(*model, *data);
    if (count > 4) model->opt.disableflags |= mjDSBL_CONTACT;
    for (int j = 0; j < model->njnt; ++j)
        if (model->jnt_type[j] == mjJNT_HINGE) data->qvel[model->jnt_dofadr[j]] = std::atof(words[3]);
    const double height = data->subtree_com[2];
    double beyond = 0.0;
    int steps = 0;
    for (; data->time < std::atof(words[2]) - 0.5 * model->opt.timestep; ++steps) {
        mj_step(model, data);
        beyond = std::max(beyond, beyondLimits(*model, *data));
    }
    mj_forward(model, data);
    int warnings = 0;
    for (const mjWarningStat& warning : data->warning) warnings += warning.number;
    std::printf("run %d %d %.9g %.9g\n", steps, warnings, height - data->subtree_com[2], beyond);
    mj_deleteData(data);
    mj_deleteModel(model);
    return 0;
}
