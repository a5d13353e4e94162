#pragma once
// Every message, and the lists from which readers, writers and tables are made.
#include "lang/messages/to_track.h"
#include "lang/messages/to_train.h"

#define EVC_MESSAGES_TO_TRAIN(X) \
  X(Message2)                    \
  X(Message3)                    \
  X(Message4)                    \
  X(Message5)                    \
  X(Message6)                    \
  X(Message7)                    \
  X(Message8)                    \
  X(Message9)                    \
  X(Message15)                   \
  X(Message15_v1_0)              \
  X(Message16)                   \
  X(Message18)                   \
  X(Message24)                   \
  X(Message27)                   \
  X(Message28)                   \
  X(Message32)                   \
  X(Message33)                   \
  X(Message34)                   \
  X(Message34_v1_0)              \
  X(Message37)                   \
  X(Message38)                   \
  X(Message38_v1_0)              \
  X(Message39)                   \
  X(Message40)                   \
  X(Message41)                   \
  X(Message43)                   \
  X(Message45)

#define EVC_MESSAGES_TO_TRACK(X) \
  X(TrainMessage129)             \
  X(TrainMessage130)             \
  X(TrainMessage131)             \
  X(TrainMessage132)             \
  X(TrainMessage132_v1_0)        \
  X(TrainMessage133)             \
  X(TrainMessage136)             \
  X(TrainMessage137)             \
  X(TrainMessage138)             \
  X(TrainMessage146)             \
  X(TrainMessage147)             \
  X(TrainMessage147_v1_0)        \
  X(TrainMessage149)             \
  X(TrainMessage150_v2_3)        \
  X(TrainMessage150)             \
  X(TrainMessage153)             \
  X(TrainMessage154)             \
  X(TrainMessage155)             \
  X(TrainMessage156)             \
  X(TrainMessage157)             \
  X(TrainMessage158)             \
  X(TrainMessage159)
