#include "kernel/report/outgoing.h"

#include "kernel/here.h"
#include "kernel/manoeuvre.h"
#include "kernel/train_category.h"
#include "radio/compose.h"

namespace evc::kernel {
namespace {

radio::TrainDataReport train_report(const State& s, const train::TrainData& t, const NationalSystem& national) {
  radio::TrainDataReport r;
  const radio::RouteData route = route_data(t);
  r.NC_CDTRAIN = route.NC_CDTRAIN;
  r.NC_TRAIN = route.NC_TRAIN;
  // The reported length and speed must not be too small: rounded up.
  const auto whole = static_cast<std::uint16_t>(t.L_TRAIN.si);
  r.L_TRAIN = static_cast<double>(whole) < t.L_TRAIN.si ? static_cast<std::uint16_t>(whole + 1) : whole;
  const double steps = t.V_MAXTRAIN.si * 3.6 / 5.0;
  r.V_MAXTRAIN = static_cast<std::uint8_t>(steps + 0.999999);
  r.M_LOADINGGAUGE = route.M_LOADINGGAUGE;
  r.M_AXLELOADCAT = route.M_AXLELOADCAT;
  r.M_AIRTIGHT = t.airtight ? 1 : 0;
  r.tractions = route.tractions;
  for (std::uint8_t NID_NTC = 0; NID_NTC < 64; ++NID_NTC)
    if ((national.available >> NID_NTC & 1u) != 0) (void)r.NID_NTC.push_back(NID_NTC);  // the first eight
  if (t.axles) r.N_AXLE = *t.axles;
  if (valid(s.data.train_running_number_status)) r.NID_OPERATIONAL = s.data.train_running_number;
  return r;
}

/// 6.6.3.4.5 [1b], 6.6.5.3.7 of 4.0.0: level 2 is reported as it was ordered, if the table has an order for level 3
/// before one for level 2.
std::uint8_t M_LEVEL_of(const State& s) {
  if (s.level.level == Level::L2 && s.level_table)
    for (const modes::OrderedLevel& entry : *s.level_table)
      if (entry.level == Level::L2) return M_LEVEL(entry.ordered_as_level_3 ? Level::L3 : Level::L2);
  return M_LEVEL(s.level.level);
}

radio::PositionReport position_report(const State& s, const position::Report& p) {
  radio::PositionReport r;
  r.Q_SCALE = p.Q_SCALE;
  r.NID_LRBG = p.NID_LRBG;
  r.NID_PRVLRBG = p.NID_PRVLRBG;
  r.D_LRBG = p.D_LRBG;
  r.Q_DIRLRBG = p.Q_DIRLRBG;
  r.Q_DLRBG = p.Q_DLRBG;
  r.L_DOUBTOVER = p.L_DOUBTOVER;
  r.L_DOUBTUNDER = p.L_DOUBTUNDER;
  r.Q_LENGTH = p.Q_LENGTH;
  if (p.L_TRAININT) r.L_TRAININT = *p.L_TRAININT;
  r.V_TRAIN = p.V_TRAIN;
  r.Q_DIRTRAIN = p.Q_DIRTRAIN;
  r.standstill = position::at_standstill(s.position);
  r.mode = s.mode;
  r.M_LEVEL = M_LEVEL_of(s);
  r.NID_NTC = s.level.nid_ntc;
  return r;
}

/// 5.21.2.2 A045: the front end with the consist; the default train data, if the mode is not SM.
std::size_t compose_manoeuvre_request(const State& s, const NationalSystem& national, radio::Intent intent,
                                      const radio::OnBoard& unit, std::span<std::uint8_t> bytes) {
  const position::Report report = position::report(s.position, s.integrity, ahead_in_request(s));
  radio::TrainDataReport t = train_report(s, s.manoeuvre.train, national);
  t.consist = s.manoeuvre.consist;
  intent.default_train_data = s.mode != Mode::SM;
  return radio::compose(intent, position_report(s, report), t, unit, s.radio.session(intent.to).M_VERSION, bytes);
}

}  // namespace

void compose_messages(State& s, const NationalSystem& national, const radio::Outbox& outbox, Log log, Outputs& out) {
  static_assert(decltype(Outputs::radio_out)::capacity() == radio::Outbox::kMessages);
  if (outbox.messages.empty()) return;
  if (outbox.lost) log.note({.what = What::message_not_sent});
  const position::Report report = position::report(s.position, s.integrity);
  const radio::PositionReport p = position_report(s, report);
  radio::TrainDataReport t = train_report(s, s.train, national);
  if (s.manoeuvre.available) t.consist = s.manoeuvre.consist;
  const radio::OnBoard unit{s.identity.NID_ENGINE,
                            {s.identity.telephone_numbers.begin(), s.identity.telephone_numbers.size()},
                            s.radio.newest};
  bool position_sent = false;
  for (const radio::Intent& intent : outbox.messages) {
    std::array<std::uint8_t, 192> bytes{};
    const radio::Session& session = s.radio.session(intent.to);
    const bool asks_manoeuvre = intent.NID_MESSAGE == message::request_for_sm;
    const std::size_t n = asks_manoeuvre ? compose_manoeuvre_request(s, national, intent, unit, bytes)
                                         : radio::compose(intent, p, t, unit, session.M_VERSION, bytes);
    OutgoingMessage message;
    message.infill_unit = session.rbc.infill_unit;
    if (intent.to != radio::Peer::supervising) message.to = RbcIdentity{session.rbc.NID_C, session.rbc.NID_RBC};
    for (std::size_t i = 0; i < n; ++i) (void)message.bytes.push_back(bytes[i]);  // 192 as well
    if (n == 0) continue;
    (void)out.radio_out.push_back(message);  // as many as fit in the outbox
    const bool to_rbc = !radio::is_infill_unit(intent.to);
    position_sent = position_sent || (to_rbc && radio::reports_position(intent.NID_MESSAGE));
  }
  if (!position_sent) return;
  position::note_reported(s.position, report);
  position::note_reported(s.integrity);
}

}  // namespace evc::kernel
