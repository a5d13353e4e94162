#pragma once
// Every packet, and the lists from which readers, writers and tables are made.
#include "lang/packets/packet_0.h"
#include "lang/packets/packet_12.h"
#include "lang/packets/packet_13.h"
#include "lang/packets/packet_131.h"
#include "lang/packets/packet_132.h"
#include "lang/packets/packet_133.h"
#include "lang/packets/packet_134.h"
#include "lang/packets/packet_135.h"
#include "lang/packets/packet_136.h"
#include "lang/packets/packet_137.h"
#include "lang/packets/packet_138.h"
#include "lang/packets/packet_139.h"
#include "lang/packets/packet_140.h"
#include "lang/packets/packet_141.h"
#include "lang/packets/packet_143.h"
#include "lang/packets/packet_145.h"
#include "lang/packets/packet_15.h"
#include "lang/packets/packet_16.h"
#include "lang/packets/packet_180.h"
#include "lang/packets/packet_181.h"
#include "lang/packets/packet_2.h"
#include "lang/packets/packet_200.h"
#include "lang/packets/packet_203.h"
#include "lang/packets/packet_206.h"
#include "lang/packets/packet_207.h"
#include "lang/packets/packet_21.h"
#include "lang/packets/packet_239.h"
#include "lang/packets/packet_254.h"
#include "lang/packets/packet_255.h"
#include "lang/packets/packet_27.h"
#include "lang/packets/packet_3.h"
#include "lang/packets/packet_39.h"
#include "lang/packets/packet_40.h"
#include "lang/packets/packet_41.h"
#include "lang/packets/packet_42.h"
#include "lang/packets/packet_44.h"
#include "lang/packets/packet_45.h"
#include "lang/packets/packet_46.h"
#include "lang/packets/packet_49.h"
#include "lang/packets/packet_5.h"
#include "lang/packets/packet_51.h"
#include "lang/packets/packet_52.h"
#include "lang/packets/packet_57.h"
#include "lang/packets/packet_58.h"
#include "lang/packets/packet_6.h"
#include "lang/packets/packet_63.h"
#include "lang/packets/packet_64.h"
#include "lang/packets/packet_65.h"
#include "lang/packets/packet_66.h"
#include "lang/packets/packet_67.h"
#include "lang/packets/packet_68.h"
#include "lang/packets/packet_69.h"
#include "lang/packets/packet_70.h"
#include "lang/packets/packet_71.h"
#include "lang/packets/packet_72.h"
#include "lang/packets/packet_76.h"
#include "lang/packets/packet_79.h"
#include "lang/packets/packet_80.h"
#include "lang/packets/packet_88.h"
#include "lang/packets/packet_90.h"
#include "lang/packets/train_packet_0.h"
#include "lang/packets/train_packet_1.h"
#include "lang/packets/train_packet_11.h"
#include "lang/packets/train_packet_2.h"
#include "lang/packets/train_packet_3.h"
#include "lang/packets/train_packet_4.h"
#include "lang/packets/train_packet_44.h"
#include "lang/packets/train_packet_5.h"
#include "lang/packets/train_packet_9.h"

// Track to train (7.4.2), newest layout first where there are several, in three parts: the readers
// of each are made in a file of their own.
#define EVC_PACKETS_TO_TRAIN_1(X) \
  X(Packet0)                      \
  X(Packet2)                      \
  X(Packet3)                      \
  X(Packet3_v1_0)                 \
  X(Packet5)                      \
  X(Packet6)                      \
  X(Packet12)                     \
  X(Packet13)                     \
  X(Packet15)                     \
  X(Packet16)                     \
  X(Packet21)                     \
  X(Packet27)                     \
  X(Packet27_v1_0)

#define EVC_PACKETS_TO_TRAIN_2(X) \
  X(Packet39)                     \
  X(Packet39_v1_0)                \
  X(Packet40)                     \
  X(Packet41)                     \
  X(Packet42)                     \
  X(Packet44)                     \
  X(Packet44_v1_0)                \
  X(Packet45)                     \
  X(Packet46)                     \
  X(Packet49)                     \
  X(Packet51)                     \
  X(Packet51_v1_0)                \
  X(Packet52)                     \
  X(Packet57)                     \
  X(Packet58)                     \
  X(Packet63)                     \
  X(Packet64)                     \
  X(Packet65)                     \
  X(Packet66)                     \
  X(Packet67)                     \
  X(Packet68)                     \
  X(Packet68_v1_0)                \
  X(Packet69)                     \
  X(Packet70)                     \
  X(Packet70_v1_0)                \
  X(Packet71)                     \
  X(Packet72)                     \
  X(Packet72_v1_0)                \
  X(Packet76)                     \
  X(Packet76_v1_0)                \
  X(Packet79)                     \
  X(Packet79_v1_0)

#define EVC_PACKETS_TO_TRAIN_3(X) \
  X(Packet80)                     \
  X(Packet80_v1_0)                \
  X(Packet88)                     \
  X(Packet90)                     \
  X(Packet131)                    \
  X(Packet132)                    \
  X(Packet133)                    \
  X(Packet134)                    \
  X(Packet135)                    \
  X(Packet136)                    \
  X(Packet137)                    \
  X(Packet138)                    \
  X(Packet139)                    \
  X(Packet140)                    \
  X(Packet140_v1_0)               \
  X(Packet141)                    \
  X(Packet143)                    \
  X(Packet145)                    \
  X(Packet180)                    \
  X(Packet181)                    \
  X(Packet200)                    \
  X(Packet203)                    \
  X(Packet206)                    \
  X(Packet207)                    \
  X(Packet239)                    \
  X(Packet254)                    \
  X(Packet255)

#define EVC_PACKETS_TO_TRAIN(X) EVC_PACKETS_TO_TRAIN_1(X) EVC_PACKETS_TO_TRAIN_2(X) EVC_PACKETS_TO_TRAIN_3(X)

// Train to track (7.4.3).
#define EVC_PACKETS_TO_TRACK(X) \
  X(TrainPacket0)               \
  X(TrainPacket0_v1_0)          \
  X(TrainPacket1)               \
  X(TrainPacket1_v1_0)          \
  X(TrainPacket2)               \
  X(TrainPacket3)               \
  X(TrainPacket4)               \
  X(TrainPacket4_v1_0)          \
  X(TrainPacket5)               \
  X(TrainPacket9)               \
  X(TrainPacket11)              \
  X(TrainPacket11_v1_0)         \
  X(TrainPacket44)
