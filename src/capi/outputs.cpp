#include "capi/outputs.h"

#include <cstring>
#include <optional>
#include <string_view>

#include "capi/codes.h"
#include "capi/guard.h"
#include "texts/texts.h"

namespace evc::capi {
namespace {

static_assert(decltype(kernel::Outputs::sessions)::capacity() == OPENEVC_SESSIONS &&
              decltype(kernel::Outputs::symbols)::capacity() == OPENEVC_SYMBOLS &&
              decltype(kernel::Outputs::texts)::capacity() == OPENEVC_TEXTS &&
              decltype(kernel::Outputs::radio_out)::capacity() == OPENEVC_RADIO_OUT &&
              decltype(kernel::Outputs::events)::capacity() == OPENEVC_EVENTS &&
              decltype(kernel::OutgoingMessage::bytes)::capacity() == sizeof openevc_radio_out{}.bytes);

double of(const std::optional<Speed>& v) { return v ? v->si : kNone; }
double of(const std::optional<Distance>& d) { return d ? d->si : kNone; }
double of(const std::optional<OdometerPlace>& p) { return p ? p->from_origin.si : kNone; }

openevc_address of(const std::optional<kernel::RbcAddress>& address) {
  openevc_address a{};
  if (!address) return a;
  a.given = 1;
  a.NID_C = address->NID_C;
  a.NID_RBC = address->NID_RBC;
  a.NID_RADIO = address->NID_RADIO;
  return a;
}

template <std::size_t N>
void put(char (&to)[N], std::string_view text) {
  const std::size_t n = text.size() < N - 1 ? text.size() : N - 1;
  std::memcpy(to, text.data(), n);
  to[n] = '\0';
}

void give_lists(openevc_outputs& to, const kernel::Outputs& o) {
  for (const Symbol symbol : o.symbols) put(to.symbols[to.symbols_count++], name(symbol));
  for (const kernel::ShownText& text : o.texts) {
    openevc_text& t = to.texts[to.texts_count++];
    t.id = text.id;
    t.Q_TEXT = text.Q_TEXT ? *text.Q_TEXT : -1;
    t.length = text.length;
    std::memcpy(t.characters, text.characters.data(), text.length);
  }
  for (const kernel::OutgoingMessage& message : o.radio_out) {
    openevc_radio_out& m = to.radio_out[to.radio_out_count++];
    m.size = static_cast<std::uint32_t>(message.bytes.size());
    std::memcpy(m.bytes, message.bytes.begin(), message.bytes.size());
  }
  static_assert(sizeof openevc_event{}.text > texts::ShortText::kMost);
  for (const kernel::Event& event : o.events) put(to.events[to.events_count++].text, texts::line_of(event).view());
}

/// For a member of 32 bits.
template <class E>
std::uint32_t bits_32(Set<E> set) {
  static_assert(static_cast<unsigned>(E::count) <= 32);
  return static_cast<std::uint32_t>(set.bits());
}

/// What the driver is shown beside symbols and texts.
void give_second_edition(openevc_outputs& to, const kernel::Outputs& o) {
  to.V_I = of(o.V_I);
  to.TTI = o.TTI ? o.TTI->si : kNone;
  to.LSSMA = of(o.LSSMA);
  to.d_indication = of(o.d_indication);
  to.geo = of(o.geo);
  to.rv_left = of(o.rv_left);
  to.MRDT_changed = o.MRDT_changed;
  to.level_valid = o.level_valid;
  static_assert(kLevels <= 8);
  to.levels_allowed = static_cast<std::uint8_t>(o.levels_allowed.bits());
  to.memo_status = o.memo_status ? static_cast<std::int32_t>(*o.memo_status) : -1;
  to.trip_reason = o.trip_reason ? static_cast<std::int32_t>(*o.trip_reason) : -1;
  for (const kernel::ShownStatus& shown : o.status_texts) to.status_texts |= std::uint64_t{1} << int(shown.text);
  to.enabled = o.enabled.bits();
  for (const kernel::RbcSession& session : o.sessions)
    to.sessions[to.sessions_count++] = {session.NID_C, session.NID_RBC, static_cast<std::int32_t>(session.phase)};
}

}  // namespace

void give_outputs(openevc_outputs& to, const kernel::Outputs& o) noexcept {
  to = {};
  to.mode = static_cast<std::int32_t>(o.mode);
  to.level = static_cast<std::int32_t>(o.level);
  to.NID_NTC = o.nid_ntc;
  to.LRBG_NID_C = o.lrbg ? o.lrbg->NID_C : -1;
  to.LRBG_NID_BG = o.lrbg ? o.lrbg->NID_BG : -1;
  to.monitoring = static_cast<std::int32_t>(o.monitoring);
  to.status = static_cast<std::int32_t>(o.status);
  to.now = o.now.si;
  to.est_front = o.est_front.from_origin.si;
  to.min_safe_front = o.min_safe_front.from_origin.si;
  to.max_safe_front = o.max_safe_front.from_origin.si;
  to.V_est = o.v.si;
  to.V_P = of(o.V_P);
  to.V_W = of(o.V_W);
  to.V_SBI = of(o.V_SBI);
  to.V_EBI = of(o.V_EBI);
  to.V_MRSP = of(o.V_MRSP);
  to.V_target = of(o.V_target);
  to.V_release = of(o.V_release);
  to.d_target = of(o.d_target);
  to.EOA = of(o.EOA);
  to.SvL = of(o.SvL);
  to.tco = o.tco;
  to.sb = o.sb;
  to.eb = o.eb;
  to.start_offered = o.start_offered;
  to.requests = bits_32(o.requests);
  to.entries = bits_32(o.entries);
  to.brake_causes = o.brake_reasons.bits();
  to.connect = of(o.radio_connect);
  to.disconnect = of(o.radio_disconnect);
  give_lists(to, o);
  give_second_edition(to, o);
}

}  // namespace evc::capi
