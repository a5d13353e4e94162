#include "lang/packet_codec_body.h"

namespace evc::lang {
EVC_PACKETS_TO_TRAIN_2(EVC_INSTANTIATE)
}  // namespace evc::lang
