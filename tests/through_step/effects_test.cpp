#include <gtest/gtest.h>

#include <cmath>

#include "ways.h"

// What the codes of packets and messages mean: the metres, km/h and names that the outputs show.
namespace evc::through_step {
namespace {

using Packets = std::vector<std::pair<unsigned, Codes>>;

/// The code at `path` of the packet `which` appears at `pointer` of the outputs.
struct Effect {
  const char* path;
  const char* pointer;
  Packets packets;
  std::size_t which = 0;
  unsigned NID_MESSAGE = 0;  ///< by the RBC; 0: by a group
  Codes message = {};        ///< with `which` beyond the packets, the field is one of the message
  const char* start = kFS1;
};

Json shown(const Effect& e, std::uint64_t code, std::uint64_t Q_SCALE) {
  OnBoard unit(OnBoard::after(e.start));
  BitList bits;
  // Other distances beside the field are in the same scale: their rows give metres.
  const auto set = [&](Codes codes, bool varied, const Json& row) {
    if (!varied) return codes;
    for (const Field& f : fields_of(row.at("elements"))) {
      if (f.path == "Q_SCALE") codes["Q_SCALE"] = Q_SCALE;
      if (variable(f.variable).at("resolution") != "Q_SCALE") continue;
      const auto given = codes.find(f.path);
      const std::uint64_t metres = given != codes.end() ? given->second : usual(f.variable, f.variable);
      if (metres != 32767) codes[f.path] = in_scale(metres, Q_SCALE);
    }
    codes[e.path] = code;
    return codes;
  };
  for (std::size_t i = 0; i < e.packets.size(); ++i) {
    const Json& packet = *find_packet("to_train", e.packets[i].first, "2.1");
    put_packet(bits, packet, set(e.packets[i].second, i == e.which, packet));
  }
  if (e.NID_MESSAGE != 0)
    unit.receive(e.NID_MESSAGE,
                 set(e.message, e.which == e.packets.size(), *find_message("to_train", e.NID_MESSAGE, "2.1")), bits);
  else
    unit.pass(200, bits);
  const Json output = unit.output();
  const Json::json_pointer at(e.pointer);
  return output.contains(at) ? output[at] : Json();
}

Json national_values(const Codes& codes) {
  OnBoard unit(OnBoard::after(kSR1));
  BitList bits;
  put_packet(bits, *find_packet("to_train", 3, "2.1"), codes);
  unit.pass(200, bits);
  return unit.retained().at("national_values");
}

/// Distances in each scale: a metre is a metre, from a fixed place.
TEST(LanguageThroughStep, DistancesInMetres) {
  const Codes to_EOA{{"L_ENDSECTION", 2000}};
  const Codes danger{{"L_ENDSECTION", 2000}, {"Q_DANGERPOINT", 1}};
  const Codes overlap{{"L_ENDSECTION", 2000}, {"Q_OVERLAP", 1}, {"T_OL", 1000}};
  const Codes axle{{"D_AXLELOAD", 800}, {"L_AXLELOAD", 400}, {"N_ITER_CAT", 1}};
  const Codes brakes{{"D_PBD", 300}, {"D_PBDSR", 800}, {"L_PBDSR", 400}, {"Q_PBDSR", 1}};
  const std::vector<Effect> effects{
      {"L_ENDSECTION", "/EOA_m", {{12, {}}}},
      {"sections/L_SECTION", "/EOA_m", {{12, {{"N_ITER", 1}, {"L_ENDSECTION", 500}}}}},
      {"D_DP", "/SvL_m", {{12, danger}}},
      {"D_OL", "/SvL_m", {{12, overlap}}},
      {"L_ENDSECTION", "/EOA_m", {{15, {}}}, 0, 3, {}, kFS2},
      {"D_REF", "/EOA_m", {{15, to_EOA}}, 1, 33, {}, kFS2},
      {"D_EMERGENCYSTOP", "/EOA_m", {}, 0, 15, {}, kFS2},
      {"D_REF", "/EOA_m", {}, 0, 15, {{"D_EMERGENCYSTOP", 50}}, kFS2},
      {"D_GRADIENT", "/planning/gradient/0/to_m", {{21, {{"G_A", 5}, {"Q_GDIR", 0}}}}},
      {"D_STATIC", "/planning/mrsp/1/at_m", {{27, {{"V_STATIC", 20}}}}},
      {"D_TRACTION", "/planning/orders/0/at_m", {{39, {{"M_VOLTAGE", 1}, {"NID_CTRACTION", 9}}}}},
      {"D_AXLELOAD", "/planning/mrsp/1/at_m", {{51, axle}}},
      {"L_AXLELOAD", "/planning/mrsp/2/at_m", {{51, axle}}},
      {"D_PBDSR", "/planning/mrsp/1/at_m", {{52, brakes}}},
      {"L_PBDSR", "/planning/mrsp/2/at_m", {{52, brakes}}},
      {"D_TSR", "/planning/mrsp/1/at_m", {{65, {{"L_TSR", 400}}}}},
      {"L_TSR", "/planning/mrsp/2/at_m", {{65, {{"D_TSR", 800}}}}},
      {"D_TRACKCOND", "/planning/orders/0/at_m", {{68, {{"M_TRACKCOND", 3}, {"L_TRACKCOND", 100}}}}},
      {"L_TRACKCOND", "/planning/orders/1/at_m", {{68, {{"M_TRACKCOND", 3}, {"D_TRACKCOND", 200}}}}},
      {"D_SUITABILITY", "/EOA_m", {{70, {{"Q_SUITABILITY", 2}, {"M_VOLTAGE", 3}}}}},
      {"D_MAMODE", "/EOA_m", {{12, {}}, {80, {}}}, 1},
      {"D_LX", "/EOA_m", {{88, {{"Q_LXSTATUS", 1}}}}},
      {"D_SR",
       "/data/sr/value/D_sr_m",
       {},
       0,
       2,
       {},
       "  given SR level 2\n  and drives at 20 km/h\n  and passes group 100\n"},
  };
  for (const Effect& e : effects) {
    std::optional<double> offset;
    for (const std::uint64_t metres : {700u, 1000u, 1200u})
      for (const std::uint64_t Q_SCALE : {0u, 1u, 2u}) {
        const std::uint64_t code = in_scale(metres, Q_SCALE);
        const Json found = shown(e, code, Q_SCALE);
        ASSERT_TRUE(found.is_number()) << e.path << " " << e.pointer << " " << code << " " << Q_SCALE;
        const double from = found.get<double>() - static_cast<double>(metres);
        if (!offset) offset = from;
        EXPECT_NEAR(from, *offset, 0.01) << e.path << " " << e.pointer << " " << metres << " m, Q_SCALE " << Q_SCALE;
      }
  }
}

/// Speeds in steps of 5 km/h.
TEST(LanguageThroughStep, SpeedsInSteps) {
  const Codes axle{{"D_AXLELOAD", 800}, {"N_ITER_CAT", 1}};
  const std::vector<Effect> effects{
      {"V_STATIC", "/planning/mrsp/1/v_kmh", {{27, {{"D_STATIC", 900}}}}},
      {"steps/V_STATIC",
       "/planning/mrsp/2/v_kmh",
       {{27, {{"D_STATIC", 500}, {"V_STATIC", 23}, {"N_ITER", 1}, {"steps/D_STATIC", 400}}}}},
      {"diffs/V_DIFF",
       "/planning/mrsp/1/v_kmh",
       {{27, {{"D_STATIC", 900}, {"V_STATIC", 27}, {"N_ITER_DIFF", 1}, {"diffs/NC_CDDIFF", 2}}}}},
      {"V_TSR", "/planning/mrsp/1/v_kmh", {{65, {{"D_TSR", 800}}}}},
      {"categories/V_AXLELOAD", "/planning/mrsp/1/v_kmh", {{51, axle}}},
      {"V_MAIN", "/V_MRSP", {{12, {}}}},
  };
  for (const Effect& e : effects)
    for (const std::uint64_t code : {14u, 17u, 22u}) {
      const Json found = shown(e, code, 1);
      ASSERT_TRUE(found.is_number()) << e.path << " " << e.pointer << " " << code;
      EXPECT_NEAR(found.get<double>(), 5.0 * static_cast<double>(code), 1e-6) << e.path << " " << code;
    }
}

/// Codes and what is shown for them.
TEST(LanguageThroughStep, CodesAndTheirMeaning) {
  struct Meaning {
    Effect effect;
    std::vector<std::pair<std::uint64_t, Json>> shown;
  };
  const Codes condition{{"D_TRACKCOND", 200}, {"L_TRACKCOND", 300}};
  const Codes traction{{"D_TRACTION", 100}, {"M_VOLTAGE", 1}};
  const Codes contact{{"Q_RBC", 1}};
  const Codes text{{"L_TEXT", 1}, {"text/X_TEXT", 65}};
  const std::vector<Meaning> meanings{
      {{"M_VERSION", "/version", {{2, {}}}}, {{16, "1.1"}, {17, "1.1"}, {32, "2.1"}, {33, "2.1"}}},
      {{"D_LEVELTR", "/level", {{41, {{"M_LEVELTR", 0}}}}}, {{32767, "0"}, {32766, "1"}, {3000, "1"}}},
      {{"D_SR", "/data/sr/value/D_sr_m", {}, 0, 2, {}, kSR2}, {{32767, nullptr}}},
      {{"G_A", "/planning/gradient/1/permille", {{21, {{"D_GRADIENT", 500}, {"Q_GDIR", 0}}}}},
       {{1, -1}, {7, -7}, {254, -254}}},
      {{"Q_GDIR", "/planning/gradient/0/permille", {{21, {{"G_A", 3}}}}}, {{0, -3}, {1, 3}}},
      {{"M_VOLTAGE", "/train_orders/traction_system/M_VOLTAGE", {{39, traction}}},
       {{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}}},
      {{"NID_CTRACTION", "/train_orders/traction_system/NID_CTRACTION", {{39, traction}}},
       {{0, 0}, {9, 9}, {1023, 1023}}},
      {{"M_CURRENT", "/train_orders/allowed_current_a/current_a", {{40, {{"D_CURRENT", 100}}}}},
       {{0, 0}, {20, 200}, {1000, 10000}, {1023, nullptr}}},
      {{"NID_C", "/data/rbc/value/NID_C", {{42, contact}}}, {{0, 0}, {1023, 1023}}},
      {{"NID_RBC", "/data/rbc/value/NID_RBC", {{42, contact}}}, {{0, 0}, {16382, 16382}}},
      {{"NID_RADIO", "/data/rbc/value/NID_RADIO", {{42, contact}}},
       {{0x0031612345678FFF, "0031612345678FFF"}, {~std::uint64_t{0}, "FFFFFFFFFFFFFFFF"}}},
      {{"M_TRACKCOND", "/track_conditions/0/symbol", {{68, condition}}}, {{3, "TC03"}, {9, "TC07"}}},
      {{"M_PLATFORM", "/train_orders/station_platform/0/M_PLATFORM", {{69, condition}}}, {{0, 0}, {13, 13}}},
      {{"Q_PLATFORM", "/train_orders/station_platform/0/Q_PLATFORM", {{69, condition}}}, {{0, 0}, {1, 1}, {2, 2}}},
      {{"text/X_TEXT", "/driver/texts/0", {{72, text}}}, {{65, "A"}, {0xE9, "\u00e9"}}},
      {{"Q_TEXTCLASS", "/messages/0/class", {{72, text}}}, {{0, "auxiliary"}, {1, "important"}}},
      {{"Q_TEXTCONFIRM", "/messages/0/ack", {{72, text}}}, {{0, false}, {1, true}, {2, true}}},
      {{"Q_TEXT", "/driver/texts/0", {{76, {}}}}, {{0, "Level crossing not protected"}, {1, "Acknowledgement"}}},
      {{"NID_VBCMK", "/data/vbc/value/0/NID_VBCMK", {{6, {{"Q_VBCO", 1}, {"T_VBC", 7}}}}}, {{0, 0}, {63, 63}}},
  };
  for (const Meaning& m : meanings)
    for (const auto& [code, expected] : m.shown) {
      const Json found = shown(m.effect, code, 1);
      EXPECT_EQ(found, expected) << m.effect.path << " " << code;
    }
}

/// Every national value of packet 3, in the file of what is kept without power (7.4.2.1.1).
TEST(LanguageThroughStep, NationalValues) {
  std::size_t seen = 0;
  for (const Field& f : fields_of(find_packet("to_train", 3, "2.1")->at("elements"))) {
    const Json& v = variable(f.variable);
    const std::string name = v.at("name");
    const std::string kind = v.at("kind");
    if (f.path.find('/') != std::string::npos || !f.needs.empty() || name.find("NV") == std::string::npos ||
        name == "D_VALIDNV" || name == "Q_NVKINT")
      continue;
    ++seen;
    for (const std::uint64_t code : codes_of(v))
      for (const std::uint64_t Q_SCALE : {0u, 1u, 2u}) {
        const Json found = national_values({{f.path, code}, {"Q_SCALE", Q_SCALE}}).at(name);
        const std::string special = v.value("special", Json::object()).value(std::to_string(code), "");
        const double scale = Q_SCALE == 0 ? 0.1 : Q_SCALE == 1 ? 1.0 : 10.0;
        SCOPED_TRACE(name + " " + std::to_string(code) + " Q_SCALE " + std::to_string(Q_SCALE));
        if (special == "infinite" || special == "never" || special == "infinity")
          EXPECT_TRUE(found.is_null() || found == "infinity") << found;
        else if (special.rfind("no maximum", 0) == 0)
          EXPECT_EQ(found, code == 61   ? "no maximum, target information"
                           : code == 62 ? "no maximum, time to indication"
                                        : "no maximum");
        else if (found.is_boolean())
          EXPECT_EQ(found, code == 1);
        else if (v.at("resolution") == "Q_SCALE")
          EXPECT_NEAR(found.get<double>(), static_cast<double>(code) * scale, 1e-6);
        else if (v.at("resolution").is_number())
          EXPECT_NEAR(found.get<double>(), static_cast<double>(code) * v.at("resolution").get<double>(), 1e-6);
        else
          EXPECT_EQ(found, code);
      }
  }
  EXPECT_EQ(seen, 28u);
  // D_VALIDNV: now, or from the place on.
  EXPECT_EQ(national_values({{"V_NVSHUNT", 7}, {"D_VALIDNV", 32767}}).at("V_NVSHUNT"), 35.0);
  EXPECT_EQ(national_values({{"V_NVSHUNT", 7}, {"D_VALIDNV", 32766}}).at("V_NVSHUNT"), 30.0);
}

TEST(LanguageThroughStep, DaysOfACover) {
  const Effect cover{"T_VBC", "/data/vbc/value/0/left_s", {{6, {{"Q_VBCO", 1}}}}};
  for (const std::uint64_t days : {1u, 7u, 255u})
    EXPECT_NEAR(shown(cover, days, 1).get<double>(), 86400.0 * static_cast<double>(days), 1.0) << days;
}

/// The integrated correction factors of packet 3: steps of Kv and Kr, Kt.
TEST(LanguageThroughStep, CorrectionFactors) {
  const Codes factors{{"Q_NVKINT", 1}, {"L_NVKRINT", 0}, {"M_NVKRINT", 20}, {"M_NVKTINT", 22}};
  const auto with = [&](const Codes& more) {
    Codes all = factors;
    for (const auto& [path, code] : more) all[path] = code;
    return national_values(all);
  };
  for (const std::uint64_t code : {0u, 20u, 31u}) {
    EXPECT_NEAR(with({{"M_NVKTINT", code}}).at("Kt_int").get<double>(), 0.05 * static_cast<double>(code), 1e-9);
    EXPECT_NEAR(with({{"M_NVKRINT", code}}).at("Kr_int")[0][1].get<double>(), 0.05 * static_cast<double>(code), 1e-9);
  }
  for (const auto& [code, metres] : variable("L_NVKRINT").at("table").items()) {
    if (code == "0") continue;
    const Json Kr =
        with({{"N_ITER_KR", 1}, {"kr_steps/L_NVKRINT", std::stoull(code)}, {"kr_steps/M_NVKRINT", 10}}).at("Kr_int");
    EXPECT_NEAR(Kr[1][0].get<double>(), metres.get<double>(), 1e-9) << code;
    EXPECT_NEAR(Kr[1][1].get<double>(), 0.5, 1e-9) << code;
  }
  for (const std::uint64_t code : {0u, 50u, 127u}) {
    const Json freight = with({{"Q_NVKVINTSET", 0}, {"M_NVKVINT_A", code}}).at("Kv_int_freight");
    EXPECT_NEAR(freight[0][1].get<double>(), 0.02 * static_cast<double>(code), 1e-9);
    const Json passenger =
        with({{"Q_NVKVINTSET", 1}, {"A_NVP12", 10}, {"A_NVP23", 30}, {"M_NVKVINT_A", code}, {"M_NVKVINT_B", 3}})
            .at("Kv_int_passenger");
    EXPECT_NEAR(passenger[0][1].get<double>(), 0.02 * static_cast<double>(code), 1e-9);
    EXPECT_NEAR(passenger[0][2].get<double>(), 0.06, 1e-9);
  }
  const Json pivots = with({{"Q_NVKVINTSET", 1}, {"A_NVP12", 10}, {"A_NVP23", 63}});
  EXPECT_NEAR(pivots.at("A_NVP12").get<double>(), 0.5, 1e-9);
  EXPECT_NEAR(pivots.at("A_NVP23").get<double>(), 3.15, 1e-9);
  EXPECT_NEAR(with({{"N_ITER_KV", 1}, {"kv_steps/V_NVKVINT", 20}, {"kv_steps/M_NVKVINT_A", 9}})
                  .at("Kv_int_freight")[1][0]
                  .get<double>(),
              100.0, 1e-9);
}

}  // namespace
}  // namespace evc::through_step
