#include <gtest/gtest.h>

#include "sim/actor/bodies/articulate.h"

namespace knuckle {
namespace {

TEST(JointTypes, followTheNamesOfCommonSkeletons)
{
    struct Case {
        const char *name, *parent, *child;
        JointType type;
    };
    for (const Case& c : {Case{"mixamorig:LeftForeArm", "mixamorig:LeftArm", "", JointType::Hinge},
                          {"mixamorig:LeftArm", "mixamorig:LeftShoulder", "mixamorig:LeftForeArm", JointType::Ball},
                          {"mixamorig:LeftShoulder", "mixamorig:Spine2", "mixamorig:LeftArm", JointType::Stiff},
                          {"mixamorig:RightUpLeg", "mixamorig:Hips", "", JointType::Ball},
                          {"mixamorig:RightLeg", "mixamorig:RightUpLeg", "", JointType::Hinge},
                          {"LeftHandThumb2", "LeftHandThumb1", "", JointType::Hinge},
                          {"Bip01 L Calf", "Bip01 L Thigh", "Bip01 L Foot", JointType::Hinge},
                          {"Bip01 R UpperArm", "Bip01 R Clavicle", "", JointType::Ball},
                          {"Bip01 Spine1", "Bip01 Spine", "", JointType::Stiff},
                          {"shin.R", "thigh.R", "foot.R", JointType::Hinge},
                          {"upper_arm.L", "shoulder.L", "forearm.L", JointType::Ball},
                          {"LowerLeg.L", "UpperLeg.L", "", JointType::Hinge},
                          {"LeftKnee", "LeftHip", "LeftAnkle", JointType::Hinge},
                          {"LeftShoulder", "LeftCollar", "LeftElbow", JointType::Ball},
                          {"RightCollar", "Chest2", "RightShoulder", JointType::Stiff},
                          {"b_LeftLeg02_016", "b_LeftLeg01_015", "", JointType::Hinge},
                          {"b_LeftLeg01_015", "b_Hip_01", "", JointType::Ball},
                          {"Neck", "Spine3", "Head", JointType::Stiff},
                          {"upperarm_twist_01_l", "upperarm_l", "", JointType::Stiff},
                          {"Head", "Neck", "", JointType::Ball},
                          {"nodes[8]", "nodes[7]", "nodes[9]", JointType::Ball}}) {
        EXPECT_EQ(jointTypeFromName(c.name, c.parent, c.child), c.type) << c.name;
    }
}

TEST(JointTypes, sidesAreReadFromNames)
{
    for (const char* left : {"LeftArm", "mixamorig:LeftArm", "arm.L", "upperarm_l", "Bip01 L Thigh", "LHipJoint",
                             "lhand", "b_LeftLeg01_015"}) {
        EXPECT_EQ(sideFromName(left), 1) << left;
    }
    for (const char* right : {"RightArm", "arm.R", "Bip01 R Thigh", "RThumb"}) {
        EXPECT_EQ(sideFromName(right), -1) << right;
    }
    for (const char* neither : {"Hips", "lowerback", "Spine1", "root", "leg"}) {
        EXPECT_EQ(sideFromName(neither), 0) << neither;
    }
}

}  // namespace
}  // namespace knuckle
