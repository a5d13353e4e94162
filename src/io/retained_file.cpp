#include "io/retained_file.h"

#include <cmath>

#include "io/date_time.h"
#include "io/rbc_contact.h"
#include "io/train_file.h"
#include "lang/translate.h"
#include "texts/texts.h"

namespace evc::io {
namespace {

using kernel::Retained;
using Out = nlohmann::ordered_json;
constexpr const char* kSchema = "evc-persistent/1";
constexpr double kLongestCover_s = Retained::kLongestCover.si;
constexpr double kFarthest_m = Retained::kFarthest.si;
/// Codes of Q_DIRLRBG, in order.
constexpr const char* kDirections[] = {"reverse", "nominal", "unknown"};

// --- From JSON

std::uint16_t read_NID_C(const JsonPlace& place) { return static_cast<std::uint16_t>(place.integer(0, 1023)); }

/// Of national values that name no country too.
std::uint16_t read_area(const JsonPlace& place) {
  return static_cast<std::uint16_t>(place.integer(0, lang::kNoCountry));
}

template <class List, class Read>
List read_list(const JsonPlace& place, Read read) {
  List list;
  for (std::size_t i = 0; i < place.size(); ++i)
    if (!list.push_back(read(place[i]))) place.fail("at most " + std::to_string(List::capacity()));
  return list;
}

/// Nothing for null.
template <class Read>
auto read_optional(const JsonPlace& place, Read read) -> std::optional<decltype(read(place))> {
  if (place.is_null()) return std::nullopt;
  return read(place);
}

Retained::Cover read_cover(const JsonPlace& place) {
  place.know_only({"NID_C", "NID_VBCMK", "left_s", "T_VBC", "utc"});
  const double left_s = place["left_s"].number(0.0, kLongestCover_s);
  // Files of before have no T_VBC: then the days that have begun.
  const auto given = place.find("T_VBC");
  const std::int64_t T_VBC = given ? given->integer(0, 255) : static_cast<std::int64_t>(std::ceil(left_s / 86400.0));
  Retained::Cover cover{read_NID_C(place["NID_C"]), static_cast<std::uint8_t>(place["NID_VBCMK"].integer(0, 63)),
                        Duration{left_s}, static_cast<std::uint8_t>(T_VBC)};
  if (const auto utc = place.find("utc")) cover.utc = read_utc(*utc);  // none where the unit had no clock
  return cover;
}

Retained::StoredLevel read_level(const JsonPlace& place) {
  place.know_only({"level", "nid_ntc"});
  return {place["level"].term<kLevelRows>(), static_cast<std::uint8_t>(place["nid_ntc"].integer(0, 255))};
}

Retained::LevelOrder read_level_order(const JsonPlace& place) {
  place.know_only({"conditional", "levels"});
  Retained::LevelOrder order;
  order.conditional = place["conditional"].boolean();
  order.table = read_list<decltype(order.table)>(place["levels"], read_level);
  if (order.table.empty()) place["levels"].fail("a level");
  return order;
}

kernel::NidLrbg read_group(const JsonPlace& place) {
  place.know_only({"NID_C", "NID_BG"});
  return {read_NID_C(place["NID_C"]), static_cast<std::uint16_t>(place["NID_BG"].integer(0, 16383))};
}

Retained::Position read_position(const JsonPlace& place) {
  place.know_only({"lrbg", "orientation", "single", "previous", "pair_orientation", "counter_rising", "cab", "ahead_m",
                   "over_m", "under_m", "Q_LOCACC_m"});
  const auto direction = [&](const char* key) {
    return static_cast<std::uint8_t>(place[key].one_of(std::span<const char* const>(kDirections)));
  };
  Retained::Position p;
  p.lrbg = read_group(place["lrbg"]);
  p.orientation = direction("orientation");
  p.single = place["single"].boolean();
  p.previous = read_optional(place["previous"], read_group);
  p.pair_orientation = direction("pair_orientation");
  p.counter_rising = place["counter_rising"].boolean();
  p.cab_B = place["cab"].one_of(texts::kCabNames) == 1;
  p.ahead = {place["ahead_m"].number(-kFarthest_m, kFarthest_m)};
  p.Q_LOCACC = {place["Q_LOCACC_m"].number(0.0, kFarthest_m)};
  p.over = {place["over_m"].number(p.Q_LOCACC.si, kFarthest_m)};  // the accuracy of the group is part of it
  p.under = {place["under_m"].number(p.Q_LOCACC.si, kFarthest_m)};
  return p;
}

Retained read_document(const JsonPlace& place) {
  place.require_schema(kSchema);
  place.know_only({"schema", "national_values", "national_areas", "national_areas_of_X_2", "national_areas_of_braking",
                   "version_X", "generic_ls_marker", "vbc", "radio_network", "level", "level_table", "level_order",
                   "rbc", "position"});
  Retained r;
  r.national_values = read_national_values(place["national_values"]);
  r.national_areas = read_list<Retained::Areas>(place["national_areas"], read_area);
  r.national_areas_of_X_2 = read_list<Retained::Areas>(place["national_areas_of_X_2"], read_area);
  r.national_areas_of_braking = read_list<Retained::Areas>(place["national_areas_of_braking"], read_area);
  r.operated_X = static_cast<std::uint8_t>(place["version_X"].integer(1, Retained::kHighestX));
  r.generic_ls_marker = place["generic_ls_marker"].boolean();
  r.covers = read_list<decltype(r.covers)>(place["vbc"], read_cover);
  r.network = read_optional(place["radio_network"], read_NID_MN);
  r.level = read_optional(place["level"], read_level);
  r.level_table = read_list<decltype(r.level_table)>(place["level_table"], read_level);
  if (const auto p = place.find("level_order")) r.level_order = read_optional(*p, read_level_order);
  r.contact = read_optional(place["rbc"], read_kept_address);
  r.position = read_optional(place["position"], read_position);
  return r;
}

// --- To JSON

template <class List, class Write>
Out list_of(const List& list, Write write) {
  Out out = Out::array();
  for (const auto& item : list) out.push_back(write(item));
  return out;
}

/// null for nothing.
template <class T, class Write>
Out optional_of(const std::optional<T>& value, Write write) {
  return value ? Out(write(*value)) : Out(nullptr);
}

Out areas_of(const Retained::Areas& areas) {
  return list_of(areas, [](std::uint16_t NID_C) { return Out(NID_C); });
}

Out cover_json(const Retained::Cover& c) {
  Out out = {{"NID_C", c.NID_C}, {"NID_VBCMK", c.NID_VBCMK}, {"left_s", c.left.si}, {"T_VBC", c.T_VBC}};
  if (c.utc) {
    std::string text;
    append_date_time(text, *c.utc);
    out["utc"] = text + "Z";
  }
  return out;
}

Out level_json(const Retained::StoredLevel& l) { return {{"level", name(l.level)}, {"nid_ntc", l.nid_ntc}}; }

Out level_order_json(const Retained::LevelOrder& order) {
  return {{"conditional", order.conditional}, {"levels", list_of(order.table, level_json)}};
}

Out address_json(const kernel::RbcAddress& a) {
  std::string digits;
  append_NID_RADIO(digits, a.NID_RADIO);
  return {{"NID_C", a.NID_C}, {"NID_RBC", a.NID_RBC}, {"NID_RADIO", digits}};
}

Out group_json(const kernel::NidLrbg& id) { return {{"NID_C", id.NID_C}, {"NID_BG", id.NID_BG}}; }

Out position_json(const Retained::Position& p) {
  return {{"lrbg", group_json(p.lrbg)},
          {"orientation", kDirections[p.orientation]},
          {"single", p.single},
          {"previous", optional_of(p.previous, group_json)},
          {"pair_orientation", kDirections[p.pair_orientation]},
          {"counter_rising", p.counter_rising},
          {"cab", texts::kCabNames[p.cab_B ? 1 : 0]},
          {"ahead_m", p.ahead.si},
          {"over_m", p.over.si},
          {"under_m", p.under.si},
          {"Q_LOCACC_m", p.Q_LOCACC.si}};
}

}  // namespace

Result<Retained> read_retained(std::string_view text, const std::string& file) {
  return guarded([&] {
    const Json document = parse_json(text, file);
    return read_document(JsonPlace(document, file));
  });
}

std::string retained_text(const Retained& r) {
  const Out out{{"schema", kSchema},
                {"national_values", national_values_json(r.national_values)},
                {"national_areas", areas_of(r.national_areas)},
                {"national_areas_of_X_2", areas_of(r.national_areas_of_X_2)},
                {"national_areas_of_braking", areas_of(r.national_areas_of_braking)},
                {"version_X", r.operated_X},
                {"generic_ls_marker", r.generic_ls_marker},
                {"vbc", list_of(r.covers, cover_json)},
                {"radio_network", optional_of(r.network, digits_of_NID_MN)},
                {"level", optional_of(r.level, level_json)},
                {"level_table", list_of(r.level_table, level_json)},
                {"level_order", optional_of(r.level_order, level_order_json)},
                {"rbc", optional_of(r.contact, address_json)},
                {"position", optional_of(r.position, position_json)}};
  return out.dump(2) + "\n";
}

}  // namespace evc::io
