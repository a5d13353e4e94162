#include "lang/packet_codec_body.h"

namespace evc::lang {
EVC_PACKETS_TO_TRAIN_3(EVC_INSTANTIATE)
EVC_PACKETS_TO_TRACK(EVC_INSTANTIATE)
}  // namespace evc::lang
