#include "io/line_file.h"

#include <algorithm>

#include "io/rbc_contact.h"
#include "terms/level.h"

namespace evc::io {
namespace {

constexpr double kFar = 1e7;  // metres; longer than any run

/// Bits as hexadecimal digits with their number; without `count_key` all digits are bits.
sim::Bits read_bits(const JsonPlace& place, const char* hex_key, const char* count_key, std::size_t most) {
  sim::Bits bits;
  const JsonPlace hex = place[hex_key];
  bits.bytes = hex.hex();
  const std::size_t digits = hex.string().size();
  const auto count = place.find(count_key);
  bits.size = count ? static_cast<std::size_t>(count->integer(1, static_cast<std::int64_t>(4 * digits))) : 4 * digits;
  if (bits.size > most) hex.fail(std::to_string(bits.size) + " bits", "at most " + std::to_string(most));
  bits.bytes.resize((bits.size + 7) / 8);
  return bits;
}

void read_groups(sim::Line& line, const JsonPlace& root) {
  const JsonPlace groups = root["balise_groups"];
  std::size_t without_bits = 0;
  line.groups = groups.size();
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const JsonPlace balises = groups[i]["balises"];
    for (std::size_t j = 0; j < balises.size(); ++j) {
      const JsonPlace place = balises[j];
      const double at = place["position_m"].number(-kFar, kFar);
      if (!place.find("telegram_hex")) {
        ++without_bits;
        continue;
      }
      // 830 user bits of a long telegram (SUBSET-036).
      line.balises.push_back({at, read_bits(place, "telegram_hex", "telegram_bits", 830), i, j});
    }
  }
  if (line.balises.empty())
    groups.fail(std::to_string(groups.size()) + " groups, " + std::to_string(without_bits) + " balises without bits",
                "telegram_hex in at least one: the on-board reads bits");
  std::stable_sort(line.balises.begin(), line.balises.end(),
                   [](const auto& a, const auto& b) { return a.position_m < b.position_m; });
}

void read_messages(sim::Line& line, const JsonPlace& root) {
  const auto messages = root.find("rbc_messages");
  for (std::size_t i = 0; messages && i < messages->size(); ++i) {
    const JsonPlace place = (*messages)[i];
    if (place.find("missing_raw") || !place.find("message_hex")) {
      ++line.absent_messages;
      continue;
    }
    sim::TracksideMessage message;
    message.seq = static_cast<int>(place["seq"].integer(0, 1000000));
    const JsonPlace trigger = place["trigger"];
    message.position_m = trigger["position_m"].number(-kFar, kFar);
    if (const auto delay = trigger.find("delay_s")) message.delay_s = delay->number(0.0, 3600.0);
    message.message = read_bits(place, "message_hex", "message_bits", 8 * 1023);
    message.index = i;
    line.radio.push_back(std::move(message));
  }
  std::stable_sort(line.radio.begin(), line.radio.end(),
                   [](const auto& a, const auto& b) { return a.position_m < b.position_m; });
}

template <class Segment>
std::vector<Segment> read_segments(const JsonPlace& track, const char* key, const char* value, double least,
                                   double most) {
  std::vector<Segment> segments;
  const auto list = track.find(key);
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    const JsonPlace place = (*list)[i];
    const double start = place["start_m"].number(-kFar, kFar);
    const double end = place["end_m"].number(start, kFar);
    segments.push_back({start, end, place[value].number(least, most)});
  }
  std::stable_sort(segments.begin(), segments.end(),
                   [](const Segment& a, const Segment& b) { return a.start_m < b.start_m; });
  return segments;
}

/// The level of the last transition that is not beyond the start.
void read_level_before_start(sim::Line& line, const JsonPlace& track) {
  const auto transitions = track.find("level_transitions");
  for (std::size_t i = 0; transitions && i < transitions->size(); ++i) {
    const JsonPlace transition = (*transitions)[i];
    const double at = transition["position_m"].number(-kFar, kFar);
    const JsonPlace levels = transition["levels"];
    const bool counts = levels.size() > 0 && at <= line.start_front_m;
    const auto level = levels.size() > 0 ? level_of(static_cast<std::uint64_t>(levels[0].integer(0, 4))) : std::nullopt;
    if (counts) line.start_level = level.value();
  }
}

}  // namespace

LineStart read_line_start(const JsonPlace& place) {
  LineStart start;
  if (const auto front = place.find("front_m")) start.front_m = front->number(-kFar, kFar);
  if (const auto level = place.find("level")) start.level = level->term<kLevelRows>();
  if (const auto mode = place.find("mode"); mode && mode->string() != "SB")
    mode->fail("\"SB\": the on-board is powered up at the start");
  if (const auto nid = place.find("nid_ntc")) start.nid_ntc = static_cast<std::uint8_t>(nid->integer(0, 255));
  return start;
}

sim::Rbc read_rbc(const JsonPlace& place) {
  sim::Rbc rbc;
  rbc.contact = read_rbc_contact(place);
  if (const auto shunting = place.find("shunting")) rbc.grants_shunting = shunting->one_of({"refuse", "grant"}) == 1;
  return rbc;
}

sim::Line read_line(const JsonPlace& root) {
  root.require_schema("etcs-line/1");
  sim::Line line;
  line.name = root["name"].string();
  line.length_m = root["length_m"].number(0.0, kFar);
  if (const auto end = root.find("end_m")) line.end_m = end->number(-kFar, kFar);
  read_groups(line, root);
  read_messages(line, root);
  const auto start = root.find("start");
  const LineStart given = start ? read_line_start(*start) : LineStart{};
  line.start_front_m = given.front_m.value_or(line.start_front_m);
  if (const auto track = root.find("physical_track")) {
    line.gradient = read_segments<sim::GradientSegment>(*track, "gradient", "gradient_permille", -200.0, 200.0);
    line.ssp = read_segments<sim::SpeedSegment>(*track, "ssp", "v_kmh", 0.0, 600.0);
    read_level_before_start(line, *track);
  }
  line.start_level = given.level.value_or(line.start_level);
  line.start_nid_ntc = given.nid_ntc.value_or(line.start_nid_ntc);
  // NID_C of the telegrams' header (8.4.2.1).
  line.rbc.contact.NID_C = static_cast<std::uint16_t>(line.balises.front().telegram.number(25, 10));
  if (const auto rbc = root.find("rbc")) line.rbc = read_rbc(*rbc);
  return line;
}

Result<sim::Line> read_line(std::string_view text, const std::string& file) {
  return guarded([&] {
    const Json document = parse_json(text, file);
    return read_line(JsonPlace(document, file));
  });
}

}  // namespace evc::io
