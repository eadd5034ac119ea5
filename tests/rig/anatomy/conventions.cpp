#include "tests/rig/anatomy/rigs.h"

namespace knuckle::test {

namespace {

const std::vector<Convention> GAMES = {
    {"Mixamo",
     "Left",
     "Right",
     {"mixamorig:Hips=hips > mixamorig:Spine=spine > mixamorig:Spine1=spine > mixamorig:Spine2=spine",
      "mixamorig:Spine2 > mixamorig:Neck=neck > mixamorig:Head=head > mixamorig:HeadTop_End=attached",
      "mixamorig:Spine2 > mixamorig:{}Shoulder=clavicle > mixamorig:{}Arm=upperArm > mixamorig:{}ForeArm=forearm > "
      "mixamorig:{}Hand=hand > mixamorig:{}HandIndex1=finger > mixamorig:{}HandIndex2=finger",
      "mixamorig:Hips > mixamorig:{}UpLeg=thigh > mixamorig:{}Leg=shin > mixamorig:{}Foot=foot > "
      "mixamorig:{}ToeBase=toe > mixamorig:{}Toe_End=attached"}},
    {"Biped",
     "L",
     "R",
     {"Bip01=control > Bip01 Pelvis=hips > Bip01 Spine=spine > Bip01 Spine1=spine > Bip01 Neck=neck > Bip01 Head=head",
      "Bip01 Head > Bip01 Ponytail1=attached",
      "Bip01 Neck > Bip01 {} Clavicle=clavicle > Bip01 {} UpperArm=upperArm > Bip01 {} Forearm=forearm > "
      "Bip01 {} Hand=hand > Bip01 {} Finger0=finger > Bip01 {} Finger01=finger",
      "Bip01 {} Forearm > Bip01 {} ForeTwist=twist", "Bip01 {} UpperArm > Bip01 {}UpArmTwist=twist",
      "Bip01 Spine > Bip01 {} Thigh=thigh > Bip01 {} Calf=shin > Bip01 {} Foot=foot > Bip01 {} Toe0=toe"}},
    {"Unreal",
     "l",
     "r",
     {"root=control > pelvis=hips > spine_01=spine > spine_02=spine > spine_03=spine > neck_01=neck > head=head",
      "spine_03 > clavicle_{}=clavicle > upperarm_{}=upperArm > lowerarm_{}=forearm > hand_{}=hand > "
      "index_01_{}=finger",
      "hand_{} > middle_01_{}=finger > middle_02_{}=finger", "upperarm_{} > upperarm_twist_01_{}=twist",
      "lowerarm_{} > lowerarm_twist_01_{}=twist", "pelvis > thigh_{}=thigh > calf_{}=shin > foot_{}=foot > ball_{}=toe",
      "thigh_{} > thigh_twist_01_{}=twist", "calf_{} > calf_twist_01_{}=twist",
      "root > ik_foot_root=control > ik_foot_{}=control"}},
    {"Source",
     "L",
     "R",
     {"ValveBiped.Bip01_Pelvis=hips > ValveBiped.Bip01_Spine=spine > ValveBiped.Bip01_Spine4=spine",
      "ValveBiped.Bip01_Spine4 > ValveBiped.Bip01_Neck1=neck > ValveBiped.Bip01_Head1=head > "
      "ValveBiped.forward=attached",
      "ValveBiped.Bip01_Spine4 > ValveBiped.Bip01_{}_Clavicle=clavicle > ValveBiped.Bip01_{}_UpperArm=upperArm > "
      "ValveBiped.Bip01_{}_Forearm=forearm > ValveBiped.Bip01_{}_Hand=hand > ValveBiped.Bip01_{}_Finger1=finger",
      "ValveBiped.Bip01_{}_UpperArm > ValveBiped.Bip01_{}_Bicep=attached",
      "ValveBiped.Bip01_{}_Forearm > ValveBiped.Bip01_{}_Ulna=twist",
      "ValveBiped.Bip01_{}_Hand > ValveBiped.Anim_Attachment_{}H=attached",
      "ValveBiped.Bip01_Pelvis > ValveBiped.Bip01_{}_Thigh=thigh > ValveBiped.Bip01_{}_Calf=shin > "
      "ValveBiped.Bip01_{}_Foot=foot > ValveBiped.Bip01_{}_Toe0=toe"}},
    {"Roblox R15",
     "Left",
     "Right",
     {"HumanoidRootPart=control > LowerTorso=hips > UpperTorso=spine > Head=head",
      "UpperTorso > {}UpperArm=upperArm > {}LowerArm=forearm > {}Hand=hand",
      "LowerTorso > {}UpperLeg=thigh > {}LowerLeg=shin > {}Foot=foot"}},
    {"Character Creator",
     "L",
     "R",
     {"CC_Base_BoneRoot=control > CC_Base_Hip=hips > CC_Base_Waist=spine > CC_Base_Spine01=spine > "
      "CC_Base_Spine02=spine",
      "CC_Base_Spine02 > CC_Base_NeckTwist01=neck > CC_Base_NeckTwist02=twist > CC_Base_Head=head",
      "CC_Base_Head > CC_Base_FacialBone=attached > CC_Base_JawRoot=attached > CC_Base_Tongue01=attached",
      "CC_Base_Spine02 > CC_Base_{}_Clavicle=clavicle > CC_Base_{}_Upperarm=upperArm > CC_Base_{}_Forearm=forearm > "
      "CC_Base_{}_Hand=hand > CC_Base_{}_Mid1=finger",
      "CC_Base_Spine02 > CC_Base_{}_Breast=attached", "CC_Base_Spine02 > CC_Base_{}_RibsTwist=attached",
      "CC_Base_{}_Forearm > CC_Base_{}_ForearmTwist01=twist", "CC_Base_{}_Forearm > CC_Base_{}_ElbowShareBone=twist",
      "CC_Base_Hip > CC_Base_Pelvis=hips",
      "CC_Base_Pelvis > CC_Base_{}_Thigh=thigh > CC_Base_{}_Calf=shin > CC_Base_{}_Foot=foot > "
      "CC_Base_{}_ToeBase=toe > CC_Base_{}_BigToe1=toe",
      "CC_Base_{}_Thigh > CC_Base_{}_ThighTwist01=twist", "CC_Base_{}_Calf > CC_Base_{}_KneeShareBone=twist"}},
    {"Second Life",
     "Left",
     "Right",
     {"mPelvis=hips > mTorso=spine > mChest=spine > mNeck=neck > mHead=head > mSkull=attached",
      "mChest > mCollar{}=clavicle > mShoulder{}=upperArm > mElbow{}=forearm > mWrist{}=hand > mHandMiddle1{}=finger",
      "mPelvis > mHip{}=thigh > mKnee{}=shin > mAnkle{}=foot > mFoot{}=toe > mToe{}=toe"}},
};

const std::vector<Convention> STUDIOS = {
    {"Rigify",
     "L",
     "R",
     {"root=control > DEF-spine=hips > DEF-spine.001=spine > DEF-spine.002=spine > DEF-spine.003=spine",
      "DEF-spine.003 > DEF-spine.004=neck > DEF-spine.005=neck > DEF-spine.006=head > DEF-jaw=attached",
      "DEF-spine.003 > DEF-shoulder.{}=clavicle > DEF-upper_arm.{}=upperArm > DEF-upper_arm.{}.001=twist > "
      "DEF-forearm.{}=forearm > DEF-forearm.{}.001=twist > DEF-hand.{}=hand > DEF-palm.01.{}=twist > "
      "DEF-f_index.01.{}=finger",
      "DEF-spine > DEF-pelvis.{}=attached", "DEF-spine.003 > DEF-breast.{}=attached", "root > MCH-foot_ik.{}=control",
      "DEF-spine > DEF-thigh.{}=thigh > DEF-thigh.{}.001=twist > DEF-shin.{}=shin > DEF-shin.{}.001=twist > "
      "DEF-foot.{}=foot > DEF-toe.{}=toe"}},
    {"Blender metarig",
     "L",
     "R",
     {"spine=hips > spine.001=spine > spine.002=spine > spine.003=spine > spine.004=neck > spine.005=neck > "
      "spine.006=head > face=attached > nose=attached",
      "spine.003 > shoulder.{}=clavicle > upper_arm.{}=upperArm > forearm.{}=forearm > hand.{}=hand > palm.01.{}=twist",
      "palm.01.{} > f_index.01.{}=finger", "spine > pelvis.{}=attached",
      "spine > thigh.{}=thigh > shin.{}=shin > foot.{}=foot > toe.{}=toe", "foot.{} > heel.02.{}=attached"}},
    {"MakeHuman",
     "L",
     "R",
     {"root=hips > spine05=spine > spine04=spine > spine01=spine > neck01=neck > neck02=neck > head=head > "
      "jaw=attached",
      "spine01 > clavicle.{}=clavicle > shoulder01.{}=twist > upperarm01.{}=upperArm > upperarm02.{}=twist > "
      "lowerarm01.{}=forearm > lowerarm02.{}=twist > wrist.{}=hand > metacarpal1.{}=twist > finger2-1.{}=finger",
      "wrist.{} > finger1-1.{}=finger",
      "root > pelvis.{}=attached > upperleg01.{}=thigh > upperleg02.{}=twist > lowerleg01.{}=shin > "
      "lowerleg02.{}=twist > foot.{}=foot > toe1-1.{}=toe"}},
    {"VRM",
     "L",
     "R",
     {"Root=control > J_Bip_C_Hips=hips > J_Bip_C_Spine=spine > J_Bip_C_Chest=spine > J_Bip_C_UpperChest=spine",
      "J_Bip_C_UpperChest > J_Bip_C_Neck=neck > J_Bip_C_Head=head > J_Sec_Hair1_01=attached > J_Sec_Hair2_01=attached",
      "J_Bip_C_Head > J_Adj_{}_FaceEye=attached", "J_Bip_C_UpperChest > J_Sec_{}_Bust1=attached",
      "J_Bip_C_UpperChest > J_Bip_{}_Shoulder=clavicle > J_Bip_{}_UpperArm=upperArm > J_Bip_{}_LowerArm=forearm > "
      "J_Bip_{}_Hand=hand > J_Bip_{}_Little1=finger",
      "J_Bip_C_Hips > J_Bip_{}_UpperLeg=thigh > J_Bip_{}_LowerLeg=shin > J_Bip_{}_Foot=foot > J_Bip_{}_ToeBase=toe",
      "J_Bip_{}_UpperLeg > J_Sec_{}_SkirtBack0_01=attached"}},
    {"Daz Genesis",
     "l",
     "r",
     {"hip=hips > pelvis=hips",
      "pelvis > {}ThighBend=thigh > {}ThighTwist=twist > {}Shin=shin > {}Foot=foot > "
      "{}Metatarsals=toe > {}Toe=toe > {}BigToe=toe",
      "hip > abdomenLower=spine > abdomenUpper=spine > chestLower=spine > chestUpper=spine > neckLower=neck > "
      "neckUpper=neck > head=head > upperTeeth=attached",
      "head > {}Eye=attached", "chestLower > {}Pectoral=attached",
      "chestUpper > {}Collar=clavicle > {}ShldrBend=upperArm > {}ShldrTwist=twist > {}ForearmBend=forearm > "
      "{}ForearmTwist=twist > {}Hand=hand > {}Carpal1=twist > {}Index1=finger",
      "{}Hand > {}Thumb1=finger"}},
    {"Quaternius",
     "L",
     "R",
     {"Bone=control > Body=control > Hips=hips > Abdomen=spine > Torso=spine > Neck=neck > Head=head",
      "Torso > Shoulder.{}=clavicle > UpperArm.{}=upperArm > LowerArm.{}=forearm > Palm2.{}=hand > Middle1.{}=finger",
      "LowerArm.{} > Palm1.{}=twist > Index.{}=finger", "LowerArm.{} > Thumb.{}=finger",
      "Body > UpperLeg.{}=thigh > LowerLeg.{}=shin", "Bone > Foot.{}=foot", "Bone > PoleTarget.{}=control"}},
    {"MikuMikuDance",
     "左",
     "右",
     {"全ての親=control > センター=control > グルーブ=control > 上半身=spine > 上半身2=spine > 首=neck > 頭=head",
      "頭 > 両目=attached", "頭 > {}目=attached", "頭 > 前髪1=attached",
      "グルーブ > 下半身=hips > スカート_0_1=attached",
      "上半身2 > {}肩=clavicle > {}腕=upperArm > {}腕捩=twist > {}ひじ=forearm > {}手捩=twist > {}手首=hand > "
      "{}人指１=finger",
      "{}手首 > {}親指０=finger", "全ての親 > {}足ＩＫ=control > {}つま先ＩＫ=control",
      "下半身 > {}足=thigh > {}ひざ=shin > {}足首=foot > {}つま先=toe"}},
    {"MikuMikuDance, English",
     "L",
     "R",
     {"mother=control > center=control > groove=control > upper body=spine > upper body2=spine > neck=neck > head=head",
      "head > eye_{}=attached", "groove > lower body=hips", "mother > leg IK_{}=control > toe IK_{}=control",
      "upper body2 > shoulder_{}=clavicle > arm_{}=upperArm > arm twist_{}=twist > elbow_{}=forearm > "
      "wrist twist_{}=twist > wrist_{}=hand > fore1_{}=finger > fore2_{}=finger",
      "wrist_{} > middle1_{}=finger", "lower body > leg_{}=thigh > knee_{}=shin > ankle_{}=foot > toe_{}=toe"}},
    {"Maya AdvancedSkeleton",
     "L",
     "R",
     {"Root_M=hips > Spine1_M=spine > Chest_M=spine > Neck_M=neck > Head_M=head > Jaw_M=attached",
      "Chest_M > Scapula_{}=clavicle > Shoulder_{}=upperArm > ShoulderPart1_{}=twist > Elbow_{}=forearm > "
      "Wrist_{}=hand",
      "Wrist_{} > IndexFinger1_{}=finger", "Wrist_{} > ThumbFinger1_{}=finger",
      "Root_M > Hip_{}=thigh > HipPart1_{}=twist > Knee_{}=shin > Ankle_{}=foot > Toes_{}=toe > ToesEnd_{}=attached"}},
    {"Maya HumanIK",
     "Left",
     "Right",
     {"Character1_Reference=control > Character1_Hips=hips > Character1_Spine=spine > Character1_Spine1=spine",
      "Character1_Spine1 > Character1_Neck=neck > Character1_Head=head",
      "Character1_Spine1 > Character1_{}Shoulder=clavicle > Character1_{}Arm=upperArm > Character1_{}ForeArm=forearm > "
      "Character1_{}Hand=hand > Character1_{}HandRing1=finger",
      "Character1_{}Arm > Character1_{}ArmRoll=twist",
      "Character1_Hips > Character1_{}UpLeg=thigh > Character1_{}UpLegRoll=twist > Character1_{}Leg=shin > "
      "Character1_{}Foot=foot > Character1_{}ToeBase=toe"}},
};

const std::vector<Convention> CAPTURE = {
    {"SMPL",
     "L",
     "R",
     {"Pelvis=hips > Spine1=spine > Spine2=spine > Spine3=spine > Neck=neck > Head=head",
      "Spine3 > {}_Collar=clavicle > {}_Shoulder=upperArm > {}_Elbow=forearm > {}_Wrist=hand > {}_Hand=twist",
      "Pelvis > {}_Hip=thigh > {}_Knee=shin > {}_Ankle=foot > {}_Foot=toe"}},
    {"SMPL-X",
     "left",
     "right",
     {"pelvis=hips > spine1=spine > spine2=spine > spine3=spine > neck=neck > head=head > jaw=attached",
      "spine3 > {}_collar=clavicle > {}_shoulder=upperArm > {}_elbow=forearm > {}_wrist=hand > {}_index1=finger",
      "head > {}_eye_smplhf=attached", "pelvis > {}_hip=thigh > {}_knee=shin > {}_ankle=foot > {}_foot=toe"}},
    {"CMU",
     "L",
     "R",
     {"Hips=hips > LowerBack=spine > Spine=spine > Spine1=spine > Neck=neck > Neck1=neck > Head=head",
      "Hips > {}HipJoint=attached", "Spine1 > {}Shoulder=clavicle > {}Arm=upperArm > {}ForeArm=forearm > {}Hand=hand",
      "{}Hand > {}FingerBase=finger > {}HandIndex1=finger", "{}Hand > {}Thumb=finger",
      "{}HipJoint > {}UpLeg=thigh > {}Leg=shin > {}Foot=foot > {}ToeBase=toe"}},
    {"Acclaim",
     "l",
     "r",
     {"root=hips > lowerback=spine > upperback=spine > thorax=spine > lowerneck=neck > upperneck=neck > head=head",
      "thorax > {}clavicle=clavicle > {}humerus=upperArm > {}radius=forearm > {}wrist=hand > {}hand=twist > "
      "{}fingers=finger",
      "{}hand > {}thumb=finger",
      "root > {}hipjoint=attached > {}femur=thigh > {}tibia=shin > {}foot=foot > {}toes=toe"}},
    {"Xsens",
     "Left",
     "Right",
     {"Hips=hips > Chest=spine > Chest2=spine > Chest3=spine > Neck=neck > Head=head",
      "Chest3 > {}Collar=clavicle > {}Shoulder=upperArm > {}Elbow=forearm > {}Wrist=hand",
      "Hips > {}Hip=thigh > {}Knee=shin > {}Ankle=foot > {}Toe=toe"}},
};

const std::vector<Convention> SELDOM = {
    {"Sides of two letters",
     "le",
     "ri",
     {"tag_origin=control > j_mainroot=hips > j_spinelower=spine > j_spineupper=spine > j_neck=neck > j_head=head",
      "j_spineupper > j_clavicle_{}=clavicle > j_shoulder_{}=upperArm > j_elbow_{}=forearm > j_wrist_{}=hand",
      "j_mainroot > j_hip_{}=thigh > j_knee_{}=shin > j_ankle_{}=foot > j_ball_{}=toe"}},
    {"Shoulders of a spine",
     "Left",
     "Right",
     {"SpineBase=hips > SpineMid=spine > SpineShoulder=spine > Neck=neck > Head=head",
      "SpineShoulder > Shoulder{}=upperArm > Elbow{}=forearm > Wrist{}=hand",
      "SpineBase > Hip{}=thigh > Knee{}=shin > Ankle{}=foot > Foot{}=toe"}},
    {"Centres",
     "L",
     "R",
     {"hip_center=hips > spine=spine > shoulder_center=spine > neck=neck > head=head",
      "shoulder_center > shoulder_{}=clavicle > arm_upper_{}=upperArm > arm_lower_{}=forearm > hand_{}=hand",
      "hip_center > leg_upper_{}=thigh > leg_lower_{}=shin > foot_{}=foot"}},
    {"Halves cut short",
     "L",
     "R",
     {"origin=control > HIPS=hips > WAIST=spine > CHEST=spine > NECK=neck > HEAD=head",
      "CHEST > {}CLAV=clavicle > {}UPARM=upperArm > {}LOARM=forearm > {}HAND=hand > handle_{}=attached",
      "HIPS > {}UPLEG=thigh > {}LOLEG=shin > {}FOOT=foot > {}TOE=toe"}},
    {"Numbers",
     "L",
     "R",
     {"skeletal_3=control > torso_joint_1=hips > torso_joint_2=spine > torso_joint_3=spine",
      "torso_joint_3 > neck_joint_1=neck > neck_joint_2=head",
      "torso_joint_3 > arm_joint_{}__1=upperArm > arm_joint_{}__2=forearm > arm_joint_{}__3=hand",
      "torso_joint_1 > leg_joint_{}__1=thigh > leg_joint_{}__2=shin > leg_joint_{}__3=foot > leg_joint_{}__5=toe"}},
    {"Letters",
     "L",
     "R",
     {"hips=hips > spine=spine > chest=spine > neck=neck > head=head",
      "chest > armA_{}=upperArm > armB_{}=forearm > armC_{}=hand", "hips > legA_{}=thigh > legB_{}=shin > legC_{}=foot",
      "hips > scabbard_{}=attached"}},
    {"Muscles",
     "L",
     "R",
     {"Hips=hips > Spine=spine > Chest=spine > Neck=neck > Head=head",
      "Chest > Bicep_{}=upperArm > Forearm_{}=forearm > Hand_{}=hand",
      "Hips > Quad_{}=thigh > Shin_{}=shin > Foot_{}=foot"}},
    {"Japanese",
     "左",
     "右",
     {"腰=hips > 背骨=spine > 首=neck > 頭=head", "背骨 > {}肩=clavicle > {}上腕=upperArm > {}前腕=forearm > {}手=hand",
      "腰 > {}太もも=thigh > {}すね=shin > {}足=foot"}},
    {"Rigify, limbs apart",
     "L",
     "R",
     {"root=control > DEF-spine=hips > DEF-spine.001=spine > DEF-spine.002=spine > DEF-spine.003=spine",
      "DEF-spine.003 > DEF-spine.004=neck > DEF-spine.006=head", "root > DEF-pelvis.{}=attached",
      "root > DEF-shoulder.{}=clavicle", "root > DEF-upper_arm.{}=upperArm > DEF-forearm.{}=forearm > DEF-hand.{}=hand",
      "root > DEF-thigh.{}=thigh > DEF-shin.{}=shin > DEF-foot.{}=foot > DEF-toe.{}=toe"}},
};

}  // namespace

const std::vector<Convention>& conventions()
{
    static const std::vector<Convention> all = [] {
        std::vector<Convention> list = GAMES;
        list.insert(list.end(), STUDIOS.begin(), STUDIOS.end());
        list.insert(list.end(), CAPTURE.begin(), CAPTURE.end());
        list.insert(list.end(), SELDOM.begin(), SELDOM.end());
        return list;
    }();
    return all;
}

}  // namespace knuckle::test
