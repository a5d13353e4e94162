#include "sim/trackside_radio.h"

#include <algorithm>
#include <array>

#include "lang/encode.h"
#include "lang/messages.h"
#include "terms/message_numbers.h"

namespace evc::sim {
namespace {

constexpr std::int64_t kSilence_ms = 20000;  // after this time a general message prevents T_NVCONTACT from expiring
// Bit positions of the header variables (8.4.4.6, 8.4.4.7).
constexpr std::size_t kStampAt = 18;
constexpr std::size_t kAfterTrainHeader = 8 + 10 + 32 + 24;
// Bits of Q_MARQSTREASON (7.5.1.118.3): Start selected, track description deleted.
constexpr std::uint32_t kHasNoAuthority = 1u | 8u;
constexpr std::uint32_t kUnknown = 0xFFFFFF;  // NID_LRBG (7.5.1.88)
constexpr std::uint16_t kNoLimit = 32767;     // of D_SR (7.5.1.25)

template <class M, class... P>
Bits message_of(const M& message, const P&... packets) {
  std::array<std::uint8_t, 256> bytes{};
  BitWriter out(bytes);
  lang::encode_message(out, message, packets...);
  const auto used = out.bytes();
  return {{used.begin(), used.end()}, 8 * used.size()};
}

void stamp(Bits& message, std::uint32_t T_TRAIN) {
  for (unsigned i = 0; i < 32 && message.bytes.size() * 8 > kStampAt + i; ++i) {
    const std::size_t at = kStampAt + i;
    const auto mask = static_cast<std::uint8_t>(0x80u >> (at % 8));
    const bool set = ((T_TRAIN >> (31 - i)) & 1u) != 0;
    message.bytes[at / 8] =
        static_cast<std::uint8_t>(set ? message.bytes[at / 8] | mask : message.bytes[at / 8] & ~mask);
  }
}

/// Movement authority, and movement authority with shifted location reference (8.7.2, 8.7.13).
bool has_movement_authority(const Bits& message) {
  const auto NID_MESSAGE = message.number(0, 8);
  return NID_MESSAGE == message::movement_authority || NID_MESSAGE == message::movement_authority_shifted;
}

}  // namespace

TracksideRadio::TracksideRadio(const Line& line, std::optional<int> last_ma, Random& random)
    : line_(line), last_ma_(last_ma), random_(random) {
  if (!line.balises.empty()) M_VERSION_ = static_cast<std::uint8_t>(line.balises.front().telegram.number(1, 7));
}

void TracksideRadio::hear(const port::Outputs& outputs, std::int64_t t_ms) {
  if (outputs.radio_disconnect && !outputs.radio_disconnect->infill_unit) {
    bearer_ = session_ = false;
    connected_at_ms_.reset();
    replies_.clear();
  }
  if (outputs.radio_connect) hear_call(*outputs.radio_connect, t_ms);
  if (!bearer_) return;
  for (const port::OutgoingMessage& message : outputs.radio_out)
    if (!message.infill_unit) answer(message, t_ms);
}

void TracksideRadio::hear_call(const port::RbcAddress& called, std::int64_t t_ms) {
  const bool busy = bearer_ || connected_at_ms_.has_value();
  const bool same = called_ && called_->NID_C == called.NID_C && called_->NID_RBC == called.NID_RBC;
  if (called.infill_unit || (busy && !same)) {
    ++unanswered_calls_;
  } else if (!busy) {
    called_ = called;
    connected_at_ms_ = t_ms + static_cast<std::int64_t>(random_.between(1500.0, 4000.0));
  }
}

void TracksideRadio::answer(const port::OutgoingMessage& message, std::int64_t t_ms) {
  const Bits bits{{message.bytes.begin(), message.bytes.end()}, 8 * message.bytes.size()};
  const std::uint32_t NID_MESSAGE = bits.number(0, 8);
  const std::uint32_t T_TRAIN = bits.number(kStampAt, 32);
  // Position packets 0 and 1 begin with NID_PACKET, L_PACKET, Q_SCALE, NID_LRBG.
  if (NID_MESSAGE == message::validated_train_data || NID_MESSAGE == message::position_report ||
      NID_MESSAGE == message::request_for_shunting)
    NID_LRBG_ = bits.number(kAfterTrainHeader + 23, 24);
  if (NID_MESSAGE == message::ma_request) NID_LRBG_ = bits.number(kAfterTrainHeader + 5 + 23, 24);
  if (NID_MESSAGE == message::som_position_report) {
    NID_LRBG_ = bits.number(kAfterTrainHeader + 2 + 23, 24);
    position_unknown_ = NID_LRBG_ == kUnknown;
  }
  position_unknown_ = position_unknown_ && NID_LRBG_ == kUnknown;
  switch (NID_MESSAGE) {
    case message::session_initiated: {
      lang::Message32 version;
      version.M_VERSION.raw = M_VERSION_;
      version.NID_LRBG.raw = kUnknown;
      reply(t_ms, message_of(version));
      break;
    }
    case message::session_terminated: {
      lang::Message39 end;
      end.NID_LRBG.raw = kUnknown;
      session_ = false;
      reply(t_ms, message_of(end));
      break;
    }
    case message::session_established:
      session_ = true;
      last_sent_ms_ = t_ms;
      break;
    case message::validated_train_data: {
      lang::Message8 acknowledgement;
      acknowledgement.NID_LRBG.raw = NID_LRBG_;
      acknowledgement.T_TRAIN_REF.raw = T_TRAIN;
      reply(t_ms, message_of(acknowledgement));
      break;
    }
    case message::request_for_shunting: {
      lang::Message27 refused;
      lang::Message28 authorised;
      refused.NID_LRBG.raw = authorised.NID_LRBG.raw = NID_LRBG_;
      refused.T_TRAIN_REF.raw = authorised.T_TRAIN_REF.raw = T_TRAIN;
      reply(t_ms, line_.rbc.grants_shunting ? message_of(authorised) : message_of(refused));
      break;
    }
    case message::ma_request:
      answer_ma_request(bits.number(kAfterTrainHeader, 5), t_ms);
      break;
    case message::som_position_report: {
      // Q_STATUS 1: the position is valid (7.5.1.143).
      const bool valid = bits.number(kAfterTrainHeader, 2) == 1;
      lang::Message41 accepted;
      lang::Message43 confirmed;
      accepted.NID_LRBG.raw = confirmed.NID_LRBG.raw = NID_LRBG_;
      reply(t_ms, valid ? message_of(confirmed) : message_of(accepted));
      break;
    }
    default:
      break;
  }
}

bool TracksideRadio::is_withheld(const TracksideMessage& message) const {
  return last_ma_ && message.seq > *last_ma_ && has_movement_authority(message.message);
}

/// An authority refers to a group that the train knows (3.6.2.2.2).
bool TracksideRadio::needs_a_group(const TracksideMessage& message) const {
  return position_unknown_ && has_movement_authority(message.message);
}

std::size_t TracksideRadio::waiting() const {
  if (!session_) return 0;
  return static_cast<std::size_t>(std::count_if(
      reached_.begin(), reached_.end(), [this](const Reached& r) { return !needs_a_group(line_.radio[r.message]); }));
}

/// A train without an authority gets the latest one whose place it has reached, else an SR authorisation. For one that
/// asks because its authority ends there is nothing newer: the next one comes at its place.
void TracksideRadio::answer_ma_request(std::uint32_t Q_MARQSTREASON, std::int64_t t_ms) {
  if ((Q_MARQSTREASON & kHasNoAuthority) == 0) return;
  for (std::size_t i = position_unknown_ ? 0 : next_; i-- > 0;) {
    const TracksideMessage& message = line_.radio[i];
    if (!has_movement_authority(message.message) || is_withheld(message)) continue;
    const bool comes_by_itself =
        std::any_of(reached_.begin(), reached_.end(), [i](const Reached& r) { return r.message == i; });
    if (!comes_by_itself) reply(t_ms, message.message);
    return;
  }
  lang::Message2 authorisation;
  authorisation.NID_LRBG.raw = NID_LRBG_;
  authorisation.Q_SCALE.raw = 1;
  authorisation.D_SR.raw = kNoLimit;
  reply(t_ms, message_of(authorisation));
}

void TracksideRadio::reply(std::int64_t t_ms, Bits message) {
  const std::int64_t due = t_ms + static_cast<std::int64_t>(random_.between(300.0, 800.0));
  // In order: a message never overtakes another one.
  const std::int64_t not_before = replies_.empty() ? due : std::max(due, replies_.back().due_ms);
  replies_.push_back({not_before, std::move(message)});
}

void TracksideRadio::send(Bits message, int seq, std::int64_t t_ms, double front_m, CycleInputs& inputs) {
  // Strictly increasing (3.16.3.3.2): two messages of one cycle differ by a hundredth of a second.
  auto T_TRAIN = static_cast<std::uint32_t>(t_ms / 10);
  if (last_stamp_ && T_TRAIN <= *last_stamp_) T_TRAIN = *last_stamp_ + 1;
  last_stamp_ = T_TRAIN;
  stamp(message, T_TRAIN);
  last_sent_ms_ = t_ms;
  deliveries_.push_back({t_ms, front_m, seq, static_cast<std::uint8_t>(message.number(0, 8))});
  inputs.radio.push_back({std::move(message), std::nullopt});
}

void TracksideRadio::deliver(std::int64_t t_ms, double front_m, CycleInputs& inputs) {
  for (; next_ < line_.radio.size() && line_.radio[next_].position_m <= front_m; ++next_) {
    const TracksideMessage& message = line_.radio[next_];
    if (is_withheld(message)) {
      ++withheld_;
      continue;
    }
    reached_.push_back({t_ms + static_cast<std::int64_t>(message.delay_s * 1000.0), next_});
  }
  if (connected_at_ms_ && *connected_at_ms_ <= t_ms) {
    connected_at_ms_.reset();
    bearer_ = true;
    inputs.levels.radio_link = RadioLink::connected;
  }
  if (!bearer_) return;
  while (!replies_.empty() && replies_.front().due_ms <= t_ms) {
    send(std::move(replies_.front().message), -1, t_ms, front_m, inputs);
    replies_.erase(replies_.begin());
  }
  if (!session_) return;
  for (std::size_t i = 0; i < reached_.size();) {
    const TracksideMessage& message = line_.radio[reached_[i].message];
    if (reached_[i].due_ms > t_ms || needs_a_group(message)) {
      ++i;
      continue;
    }
    send(message.message, message.seq, t_ms, front_m, inputs);
    reached_.erase(reached_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (t_ms - last_sent_ms_ < kSilence_ms) return;
  lang::Message24 nothing;
  nothing.NID_LRBG.raw = NID_LRBG_;
  send(message_of(nothing), -1, t_ms, front_m, inputs);
}

}  // namespace evc::sim
