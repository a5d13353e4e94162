#include "lang/translate.h"

#include <array>

namespace evc::lang {
namespace {

// 6.6.3.2.3 [3]: NC_DIFF of X = 1 -> Q_DIFF, NC_CDDIFF, NC_DIFF. {1}: whether the speed for an "other"
// category replaces the one for cant deficiency (Q_DIFF 1) or applies in addition (2) depends on the train, which is
// not known here.
struct Category {
  bool other;
  std::uint8_t code;  // NC_CDDIFF, or NC_DIFF of X = 2 if `other`
};
constexpr std::array<Category, 14> categories{{{false, 9},
                                               {false, 0},
                                               {false, 1},
                                               {false, 2},
                                               {false, 3},
                                               {false, 4},
                                               {false, 5},
                                               {false, 7},
                                               {false, 10},
                                               {true, 0},
                                               {true, 1},
                                               {true, 2},
                                               {false, 8},
                                               {false, 6}}};

// 6.6.3.2.3 [13]: M_TRACTION of X = 1 -> M_VOLTAGE, NID_CTRACTION.
struct Traction {
  std::uint8_t M_TRACTION, M_VOLTAGE;
  std::uint16_t NID_CTRACTION;
};
constexpr std::array<Traction, 23> tractions{
    {{0, 0, 0},   {1, 3, 10},  {2, 1, 12},  {3, 1, 13},  {5, 4, 14},  {6, 4, 1},   {7, 1, 2},   {8, 1, 3},
     {11, 2, 19}, {12, 2, 20}, {13, 2, 21}, {15, 2, 22}, {26, 1, 11}, {31, 1, 18}, {32, 3, 15}, {33, 3, 16},
     {34, 1, 17}, {41, 2, 4},  {42, 2, 5},  {43, 2, 6},  {44, 2, 7},  {45, 2, 8},  {46, 2, 9}}};
const Traction* find_traction(var::M_TRACTION m) {
  for (const Traction& t : tractions)
    if (t.M_TRACTION == m.raw) return &t;
  return nullptr;
}

// 6.6.3.2.3 [5]: the load of X = 1 in steps of 0.5 t -> category (A 0, HS17 1, B1 2, C2 4, D2 7, E4 11).
std::uint8_t axle_load_category(var::M_AXLELOAD m) {
  if (m.raw <= 32) return 0;
  if (m.raw <= 34) return 1;
  if (m.raw <= 36) return 2;
  if (m.raw <= 40) return 4;
  if (m.raw <= 45) return 7;
  return 11;
}

/// Converts every element of `from` by `make` into one of `to`; both have the same capacity.
template <class From, class To, class Make>
void each_element(const From& from, To& to, Make make) {
  static_assert(From::capacity() <= To::capacity());
  to.clear();
  for (const auto& e : from) (void)to.push_back(make(e));
}

Packet27_diffs category(const Packet27_v1_0_diffs& d) {
  Packet27_diffs to;
  const Category c = d.NC_DIFF.raw < categories.size() ? categories[d.NC_DIFF.raw] : Category{true, 15};
  to.Q_DIFF.raw = static_cast<std::uint8_t>(c.other ? kQ_DIFF_by_train : 0);
  (c.other ? to.NC_DIFF.raw : to.NC_CDDIFF.raw) = c.code;
  to.V_DIFF = d.V_DIFF;
  return to;
}

// [14]
var::M_POSITION position(var::M_POSITION_V1 p) { return {p.raw == 1048575u ? 16777215u : p.raw}; }
// [8]
var::M_TRACKCOND condition(var::M_TRACKCOND_V1 c) {
  return {static_cast<std::uint8_t>(c.raw == 1 || c.raw == 2 ? 0 : c.raw)};
}

// [22] backwards: in X = 3 "not limited by level" is 4.
var::M_LEVELTEXTDISPLAY level_of_text(var::M_LEVELTEXTDISPLAY level) { return level; }
var::M_LEVELTEXTDISPLAY level_of_text(var::M_LEVELTEXTDISPLAY_V3 level) {
  return {static_cast<std::uint8_t>(level.raw == 4 ? 5 : level.raw)};
}

template <class From, class To>
void copy_text_conditions(const From& from, To& to) {
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.Q_TEXTCLASS = from.Q_TEXTCLASS;
  to.Q_TEXTDISPLAY = from.Q_TEXTDISPLAY;
  to.D_TEXTDISPLAY = from.D_TEXTDISPLAY;
  to.M_MODETEXTDISPLAY_START.raw = from.M_MODETEXTDISPLAY_START.raw;
  to.M_LEVELTEXTDISPLAY_START = level_of_text(from.M_LEVELTEXTDISPLAY_START);
  to.NID_NTC_START = from.NID_NTC_START;
  to.L_TEXTDISPLAY = from.L_TEXTDISPLAY;
  to.T_TEXTDISPLAY = from.T_TEXTDISPLAY;
  to.M_MODETEXTDISPLAY_END.raw = from.M_MODETEXTDISPLAY_END.raw;
  to.M_LEVELTEXTDISPLAY_END = level_of_text(from.M_LEVELTEXTDISPLAY_END);
  to.NID_NTC_END = from.NID_NTC_END;
  to.Q_TEXTCONFIRM.raw = from.Q_TEXTCONFIRM.raw;
  if constexpr (requires { from.Q_TEXTREPORT; }) {
    to.Q_CONFTEXTDISPLAY = from.Q_CONFTEXTDISPLAY;
    to.Q_TEXTREPORT = from.Q_TEXTREPORT;
    to.NID_TEXTMESSAGE = from.NID_TEXTMESSAGE;
    to.NID_C = from.NID_C;
    to.NID_RBC = from.NID_RBC;
  } else {
    // [6]: no report, and the acknowledgement always ends the display
    to.Q_CONFTEXTDISPLAY = {};
    to.Q_TEXTREPORT = {};
    to.NID_TEXTMESSAGE = {};
    to.NID_C = {};
    to.NID_RBC = {};
  }
}

}  // namespace

bool translate(const Packet200& from, Packet0& to) {
  to.NID_VBCMK = from.NID_VBCMK;
  return true;
}

bool translate(const Packet3_v1_0& from, Packet3& to) {
  to = Packet3{};
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.D_VALIDNV.raw = from.D_VALIDNV.raw;
  // X = 1 has one list of countries; in X = 2 the first country is before the counter. The values of an empty list hold
  // up to the next group (3.18.2.8.1, 3.18.2.10).
  to.NID_C.raw = from.areas.empty() ? kNoCountry : from.areas[0].NID_C.raw;
  for (std::size_t i = 1; i < from.areas.size(); ++i) (void)to.areas.push_back({from.areas[i].NID_C});
  to.V_NVSHUNT = from.V_NVSHUNT;
  to.V_NVSTFF = from.V_NVSTFF;
  to.V_NVONSIGHT = from.V_NVONSIGHT;
  to.V_NVUNFIT = from.V_NVUNFIT;
  to.V_NVREL = from.V_NVREL;
  to.D_NVROLL = from.D_NVROLL;
  to.Q_NVSBTSMPERM.raw = from.Q_NVSRBKTRG.raw;
  to.Q_NVEMRRLS = from.Q_NVEMRRLS;
  to.V_NVALLOWOVTRP = from.V_NVALLOWOVTRP;
  to.V_NVSUPOVTRP = from.V_NVSUPOVTRP;
  to.D_NVOVTRP = from.D_NVOVTRP;
  to.T_NVOVTRP = from.T_NVOVTRP;
  to.D_NVPOTRP = from.D_NVPOTRP;
  to.M_NVCONTACT = from.M_NVCONTACT;
  to.T_NVCONTACT = from.T_NVCONTACT;
  to.M_NVDERUN = from.M_NVDERUN;
  to.D_NVSTFF = from.D_NVSTFF;
  to.Q_NVDRIVER_ADHES = from.Q_NVDRIVER_ADHES;
  // A.3.2 defaults
  to.V_NVLIMSUPERV.raw = 20;   // 100 km/h
  to.Q_NVLOCACC.raw = 12;      // m
  to.A_NVMAXREDADH1.raw = 20;  // 1.0 m/s2
  to.A_NVMAXREDADH2.raw = 14;  // 0.7 m/s2
  to.A_NVMAXREDADH3.raw = 14;  // 0.7 m/s2
  to.M_NVAVADH.raw = 0;
  to.M_NVEBCL.raw = 9;  // 99.9999999 %
  return true;
}

bool translate(const Packet27_v1_0& from, Packet27& to) {
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.D_STATIC = from.D_STATIC;
  to.V_STATIC = from.V_STATIC;
  to.Q_FRONT = from.Q_FRONT;
  each_element(from.diffs, to.diffs, category);
  each_element(from.steps, to.steps, [](const Packet27_v1_0_steps& s) {
    Packet27_steps step;
    step.D_STATIC = s.D_STATIC;
    step.V_STATIC = s.V_STATIC;
    step.Q_FRONT = s.Q_FRONT;
    each_element(s.diffs, step.diffs, category);
    return step;
  });
  return true;
}

bool translate(const Packet39_v1_0& from, Packet39& to) {
  const Traction* t = find_traction(from.M_TRACTION);
  if (t == nullptr) return false;
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.D_TRACTION = from.D_TRACTION;
  to.M_VOLTAGE.raw = t->M_VOLTAGE;
  to.NID_CTRACTION.raw = t->NID_CTRACTION;
  return true;
}
bool translate(const Packet239& from, Packet39& to) {
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.D_TRACTION = from.D_TRACTION;
  to.M_VOLTAGE = from.M_VOLTAGE;
  to.NID_CTRACTION = from.NID_CTRACTION;
  return true;
}

bool translate(const Packet41_v3_0& from, Packet41& to) {
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.D_LEVELTR = from.D_LEVELTR;
  to.M_LEVELTR.raw = from.M_LEVELTR.raw;
  to.NID_NTC = from.NID_NTC;
  to.L_ACKLEVELTR = from.L_ACKLEVELTR;
  each_element(from.levels, to.levels, [](const auto& level) {
    return Packet41_levels{{level.M_LEVELTR.raw}, level.NID_NTC, level.L_ACKLEVELTR};
  });
  return true;
}
bool translate(const Packet46_v3_0& from, Packet46& to) {
  to.Q_DIR = from.Q_DIR;
  to.M_LEVELTR.raw = from.M_LEVELTR.raw;
  to.NID_NTC = from.NID_NTC;
  each_element(from.levels, to.levels, [](const auto& level) {
    return Packet46_levels{{level.M_LEVELTR.raw}, level.NID_NTC};
  });
  return true;
}

bool translate(const Packet32& from, Packet42& to) {
  to = {from.Q_DIR, from.Q_RBC, from.NID_C, from.NID_RBC, {kNo_number}, from.Q_SLEEPSESSION};
  return true;
}
bool translate(const Packet31& from, Packet131& to) {
  to = {from.Q_DIR, from.Q_SCALE, from.D_RBCTR, from.NID_C, from.NID_RBC, {kNo_number}, from.Q_SLEEPSESSION};
  return true;
}

bool translate(const Packet44_v1_0& from, Packet44& to) {
  to.Q_DIR = from.Q_DIR;
  to.NID_XUSER = from.NID_XUSER;
  to.NID_NTC = {};
  // [20]: the two users of X = 1 that are national systems
  if (from.NID_XUSER.raw == 13 || from.NID_XUSER.raw == 39) {
    to.NID_NTC.raw = static_cast<std::uint8_t>(from.NID_XUSER.raw == 13 ? 28 : 11);
    to.NID_XUSER.raw = 102;
  }
  to.OTHER_DATA = from.OTHER_DATA;
  return true;
}

bool translate(const Packet45& from, Packet45_v3_0& to) {
  to = {from.Q_DIR, {kGsm_r_only}, from.NID_MN};
  return true;
}

bool translate(const Packet51_v1_0& from, Packet51& to) {
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.Q_TRACKINIT = from.Q_TRACKINIT;
  to.D_TRACKINIT = {};  // [4]
  to.D_AXLELOAD = from.D_AXLELOAD;
  to.L_AXLELOAD = from.L_AXLELOAD;
  to.Q_FRONT = from.Q_FRONT;
  const auto category = [](const Packet51_v1_0_categories& c) {
    Packet51_categories load;
    load.M_AXLELOADCAT.raw = axle_load_category(c.M_AXLELOAD);
    load.V_AXLELOAD = c.V_AXLELOAD;
    return load;
  };
  each_element(from.categories, to.categories, category);
  each_element(from.restrictions, to.restrictions, [&](const Packet51_v1_0_restrictions& r) {
    Packet51_restrictions restriction;
    restriction.D_AXLELOAD = r.D_AXLELOAD;
    restriction.L_AXLELOAD = r.L_AXLELOAD;
    restriction.Q_FRONT = r.Q_FRONT;
    each_element(r.categories, restriction.categories, category);
    return restriction;
  });
  return true;
}

bool translate(const Packet68_v1_0& from, Packet68& to) {
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.Q_TRACKINIT = from.Q_TRACKINIT;
  to.D_TRACKINIT = from.D_TRACKINIT;
  to.D_TRACKCOND = from.D_TRACKCOND;
  to.L_TRACKCOND = from.L_TRACKCOND;
  to.M_TRACKCOND = condition(from.M_TRACKCOND);
  each_element(from.conditions, to.conditions, [](const auto& c) {
    return Packet68_conditions{c.D_TRACKCOND, c.L_TRACKCOND, condition(c.M_TRACKCOND)};
  });
  return true;
}
bool translate(const Packet206& from, Packet68& to) {
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.Q_TRACKINIT = from.Q_TRACKINIT;
  to.D_TRACKINIT = from.D_TRACKINIT;
  to.D_TRACKCOND = from.D_TRACKCOND;
  to.L_TRACKCOND = from.L_TRACKCOND;
  to.M_TRACKCOND.raw = from.M_TRACKCONDBC.raw;
  each_element(from.conditions, to.conditions, [](const auto& c) {
    return Packet68_conditions{c.D_TRACKCOND, c.L_TRACKCOND, {c.M_TRACKCONDBC.raw}};
  });
  return true;
}

bool translate(const Packet70_v1_0& from, Packet70& to) {
  to = Packet70{};
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.Q_TRACKINIT = from.Q_TRACKINIT;
  to.D_TRACKINIT = from.D_TRACKINIT;
  if (from.Q_TRACKINIT.raw == 1) return true;  // [11]
  // [12]: only points for known traction systems are used; distances are increments, so those of the points left out
  // are added to the next one used. More than its variable holds: it counts from the farthest place that can be said,
  // which is nearer.
  std::uint32_t distance = 0;
  bool first = true;
  const auto take = [&](var::D_SUITABILITY D_SUITABILITY, var::Q_SUITABILITY Q_SUITABILITY,
                        var::M_TRACTION M_TRACTION) {
    distance += D_SUITABILITY.raw;
    const Traction* t = Q_SUITABILITY.raw == 2 ? find_traction(M_TRACTION) : nullptr;
    if (t == nullptr) return true;
    constexpr std::uint32_t kFarthest = all_ones(var::D_SUITABILITY::bits);
    Packet70_points point;
    point.D_SUITABILITY.raw = static_cast<std::uint16_t>(distance < kFarthest ? distance : kFarthest);
    point.Q_SUITABILITY.raw = 2;
    point.M_VOLTAGE.raw = t->M_VOLTAGE;
    point.NID_CTRACTION.raw = t->NID_CTRACTION;
    distance -= point.D_SUITABILITY.raw;
    if (!first) return to.points.push_back(point);
    first = false;
    to.D_SUITABILITY = point.D_SUITABILITY;
    to.Q_SUITABILITY = point.Q_SUITABILITY;
    to.M_VOLTAGE = point.M_VOLTAGE;
    to.NID_CTRACTION = point.NID_CTRACTION;
    return true;
  };
  if (!take(from.D_SUITABILITY, from.Q_SUITABILITY, from.M_TRACTION)) return false;
  for (const auto& p : from.points)
    if (!take(p.D_SUITABILITY, p.Q_SUITABILITY, p.M_TRACTION)) return false;
  return !first;
}
bool translate(const Packet207& from, Packet70& to) {
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.Q_TRACKINIT = from.Q_TRACKINIT;
  to.D_TRACKINIT = from.D_TRACKINIT;
  to.D_SUITABILITY = from.D_SUITABILITY;
  to.Q_SUITABILITY = from.Q_SUITABILITY;
  to.M_LINEGAUGE = from.M_LINEGAUGE;
  to.M_AXLELOADCAT = from.M_AXLELOADCAT;
  to.M_VOLTAGE = from.M_VOLTAGE;
  to.NID_CTRACTION = from.NID_CTRACTION;
  to.points = from.points;
  return true;
}

namespace {
Packet70_v3_0_points with_categories(const Packet70_points& p) {
  Packet70_v3_0_points to{p.D_SUITABILITY, p.Q_SUITABILITY, p.M_LINEGAUGE, {}, p.M_VOLTAGE, p.NID_CTRACTION};
  if (p.Q_SUITABILITY.raw == 1)
    to.M_LINEAXLELOADCAT.raw = static_cast<std::uint16_t>(all_ones(p.M_AXLELOADCAT.raw + 1u));
  return to;
}
/// Of a packet 70 of 2.0 to 2.3, or 207, which has the same layout.
template <class From>
bool translate_suitability(const From& from, Packet70_v3_0& to) {
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.Q_TRACKINIT = from.Q_TRACKINIT;
  to.D_TRACKINIT = from.D_TRACKINIT;
  const Packet70_v3_0_points first = with_categories(from.first_points());
  to.D_SUITABILITY = first.D_SUITABILITY;
  to.Q_SUITABILITY = first.Q_SUITABILITY;
  to.M_LINEGAUGE = first.M_LINEGAUGE;
  to.M_LINEAXLELOADCAT = first.M_LINEAXLELOADCAT;
  to.M_VOLTAGE = first.M_VOLTAGE;
  to.NID_CTRACTION = first.NID_CTRACTION;
  each_element(from.points, to.points, with_categories);
  return true;
}
}  // namespace
bool translate(const Packet70& from, Packet70_v3_0& to) { return translate_suitability(from, to); }
bool translate(const Packet70_v1_0& from, Packet70_v3_0& to) {
  Packet70 working;
  return translate(from, working) && translate_suitability(working, to);
}
bool translate(const Packet207& from, Packet70_v3_0& to) { return translate_suitability(from, to); }

namespace {
template <class From>
bool translate_plain_text(const From& from, Packet72& to) {
  copy_text_conditions(from, to);
  to.text = from.text;
  return true;
}
template <class From>
bool translate_fixed_text(const From& from, Packet76& to) {
  copy_text_conditions(from, to);
  to.Q_TEXT = from.Q_TEXT;
  return true;
}
}  // namespace
bool translate(const Packet72_v1_0& from, Packet72& to) { return translate_plain_text(from, to); }
bool translate(const Packet73_v2_2& from, Packet72& to) { return translate_plain_text(from, to); }
bool translate(const Packet73_v2_3& from, Packet72& to) { return translate_plain_text(from, to); }
bool translate(const Packet73& from, Packet72& to) { return translate_plain_text(from, to); }
bool translate(const Packet76_v1_0& from, Packet76& to) { return translate_fixed_text(from, to); }
bool translate(const Packet74_v2_2& from, Packet76& to) { return translate_fixed_text(from, to); }
bool translate(const Packet74_v2_3& from, Packet76& to) { return translate_fixed_text(from, to); }
bool translate(const Packet74& from, Packet76& to) { return translate_fixed_text(from, to); }

bool translate(const Packet79_v1_0& from, Packet79& to) {
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.Q_NEWCOUNTRY = from.Q_NEWCOUNTRY;
  to.NID_C = from.NID_C;
  to.NID_BG = from.NID_BG;
  to.D_POSOFF = from.D_POSOFF;
  to.Q_MPOSITION = from.Q_MPOSITION;
  to.M_POSITION = position(from.M_POSITION);
  each_element(from.references, to.references, [](const auto& r) {
    return Packet79_references{r.Q_NEWCOUNTRY, r.NID_C, r.NID_BG, r.D_POSOFF, r.Q_MPOSITION, position(r.M_POSITION)};
  });
  return true;
}

bool translate(const Packet80_v1_0& from, Packet80& to) {
  to.Q_DIR = from.Q_DIR;
  to.Q_SCALE = from.Q_SCALE;
  to.D_MAMODE = from.D_MAMODE;
  to.M_MAMODE.raw = from.M_MAMODE.raw;
  to.V_MAMODE = from.V_MAMODE;
  to.L_MAMODE = from.L_MAMODE;
  to.L_ACKMAMODE = from.L_ACKMAMODE;
  to.Q_MAMODE.raw = 1;  // [7]
  each_element(from.modes, to.modes, [](const auto& m) {
    return Packet80_modes{m.D_MAMODE, {m.M_MAMODE.raw}, m.V_MAMODE, m.L_MAMODE, m.L_ACKMAMODE, {1}};
  });
  return true;
}

bool translate(const Packet140_v1_0& from, Packet140& to) {
  to.Q_DIR = from.Q_DIR;
  // [10]: digits F move to the right.
  std::uint32_t number = 0xFFFFFFFFu;
  unsigned places = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const std::uint32_t digit = (from.NID_OPERATIONAL.raw >> (28 - 4 * i)) & 15u;
    if (digit == 15u) continue;
    const unsigned shift = 28 - 4 * places++;
    number = (number & ~(15u << shift)) | (digit << shift);
  }
  to.NID_OPERATIONAL.raw = number;
  return places > 0;  // "unknown" has no code in X = 2
}

namespace {

// 6.6.3.4.5 [1a]: passive shunting is reported as shunting.
var::M_MODE_V1 mode(var::M_MODE m) { return {static_cast<std::uint8_t>(m.raw == 15 ? 3 : m.raw)}; }

}  // namespace

TrainPacket0_v1_0 for_version_1(const TrainPacket0& p) {
  return {p.Q_SCALE,  p.NID_LRBG,   p.D_LRBG,  p.Q_DIRLRBG,  p.Q_DLRBG,      p.L_DOUBTOVER, p.L_DOUBTUNDER,
          p.Q_LENGTH, p.L_TRAININT, p.V_TRAIN, p.Q_DIRTRAIN, mode(p.M_MODE), p.M_LEVEL,     p.NID_NTC};
}
TrainPacket1_v1_0 for_version_1(const TrainPacket1& p) {
  return {p.Q_SCALE, p.NID_LRBG,    p.NID_PRVLRBG,  p.D_LRBG,   p.Q_DIRLRBG,
          p.Q_DLRBG, p.L_DOUBTOVER, p.L_DOUBTUNDER, p.Q_LENGTH, p.L_TRAININT,
          p.V_TRAIN, p.Q_DIRTRAIN,  mode(p.M_MODE), p.M_LEVEL,  p.NID_NTC};
}
TrainPacket4_v1_0 for_version_1(const TrainPacket4& p) {
  // [2]: 6 (safety critical fault) is 7 in X = 1; the caller must not send 7 and 8.
  return {{static_cast<std::uint8_t>(p.M_ERROR.raw == 6 ? 7 : p.M_ERROR.raw)}};
}

TrainPacket11_v1_0 for_version_1(const TrainPacket11& p, var::NID_OPERATIONAL_V1 NID_OPERATIONAL) {
  TrainPacket11_v1_0 to;
  to.NID_OPERATIONAL = NID_OPERATIONAL;
  // [3b]: the bit of the cant deficiency category, and one for the other category
  constexpr std::array<std::uint8_t, 11> bit_of_category{1, 2, 3, 4, 5, 6, 13, 7, 12, 0, 8};
  unsigned bits = p.NC_CDTRAIN.raw < bit_of_category.size() ? 1u << bit_of_category[p.NC_CDTRAIN.raw] : 0u;
  for (unsigned i = 0; i < 3; ++i)
    if (p.NC_TRAIN.raw == (1u << i)) bits |= 1u << (9 + i);
  to.NC_TRAIN.raw = static_cast<std::uint16_t>(bits);
  to.L_TRAIN = p.L_TRAIN;
  to.V_MAXTRAIN = p.V_MAXTRAIN;
  to.M_LOADINGGAUGE.raw = 0;  // [3c]
  // [3d]: 16, 17, 18, 18, 20, 20, 20, 22.5 (D2 to D4XL), 25, 25 t in steps of 0.5 t
  constexpr std::array<std::uint8_t, 13> load{32, 34, 36, 36, 40, 40, 40, 45, 45, 45, 45, 50, 50};
  to.M_AXLELOAD.raw = p.M_AXLELOADCAT.raw < load.size() ? load[p.M_AXLELOADCAT.raw] : std::uint8_t{126};
  to.M_AIRTIGHT = p.M_AIRTIGHT;
  for (const auto& n : p.ntcs) (void)to.ntcs.push_back({n.NID_NTC});  // [3e]: no traction systems
  return to;
}

TrainMessage132_v1_0 for_version_1(const TrainMessage132& m) {
  // [4]
  return {m.T_TRAIN, m.NID_ENGINE, {static_cast<std::uint8_t>((m.Q_MARQSTREASON.raw >> 3) & 1u)}};
}
TrainMessage147_v1_0 for_version_1(const TrainMessage147& m) {
  // [5]
  constexpr std::array<std::uint8_t, 4> code{0, 0, 2, 1};
  return {m.T_TRAIN, m.NID_ENGINE, m.NID_EM, {code[m.Q_EMERGENCYSTOP.raw & 3u]}};
}

}  // namespace evc::lang
