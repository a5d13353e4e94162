#include "ride/given.h"

#include <bit>
#include <concepts>
#include <type_traits>
#include <utility>
#include <vector>

namespace evc::ride {
namespace {

/// Of the order of fields below: a change of that is a new version. web/index.html names it too.
constexpr std::uint32_t kVersion = 0x45564303;

/// A byte is one, every other number is eight: a std::size_t is not as wide everywhere.
template <class Number>
constexpr unsigned kWidth = sizeof(Number) == 1 ? 1 : 8;

/// Appends numbers to bytes.
class Writer {
 public:
  static constexpr bool reads = false;
  template <class Number>
  void number(Number& value) {
    std::uint64_t bits = 0;
    if constexpr (std::floating_point<Number>)
      bits = std::bit_cast<std::uint64_t>(value);
    else
      bits = static_cast<std::uint64_t>(value);
    for (unsigned i = 0; i < kWidth<Number>; ++i) bytes.push_back(static_cast<char>(bits >> 8 * i & 0xFF));
  }
  std::string bytes;
};

/// Takes numbers from bytes; a fault stays, and what is read behind it is 0.
class Reader {
 public:
  static constexpr bool reads = true;
  explicit Reader(std::string_view bytes) : left_(bytes) {}
  template <class Number>
  void number(Number& value) {
    std::uint64_t bits = 0;
    constexpr unsigned width = kWidth<Number>;
    if (left_.size() < width) {
      good_ = false;
      left_ = {};
    } else {
      for (unsigned i = 0; i < width; ++i) bits |= std::uint64_t{static_cast<std::uint8_t>(left_[i])} << 8 * i;
      left_.remove_prefix(width);
    }
    if constexpr (std::floating_point<Number>)
      value = std::bit_cast<double>(bits);
    else
      value = static_cast<Number>(bits);
  }
  void fail() { good_ = false; }
  bool good() const { return good_; }
  bool at_end() const { return left_.empty(); }
  /// Items that can still follow, each of at least a byte.
  std::size_t most() const { return left_.size(); }

 private:
  std::string_view left_;
  bool good_ = true;
};

// One list of fields for both ways: exchange(archive, value) writes the value or replaces it by what is read.

template <class Archive, class T>
requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void exchange(Archive& a, T& value) { a.number(value); }
template <class Archive, class T>
requires requires(T& quantity) { quantity.si; }
void exchange(Archive& a, T& quantity) { a.number(quantity.si); }
template <class Archive>
void exchange(Archive& a, train::Factor& factor) {
  a.number(factor.hundred_millionths);
}

template <class Archive, class T>
void exchange(Archive& a, std::vector<T>& list);
template <class Archive, class T>
void exchange(Archive& a, std::optional<T>& value);
template <class Archive, class T, std::size_t N>
void exchange(Archive& a, std::array<T, N>& list);
template <class Archive, class T, std::size_t N>
void exchange(Archive& a, InplaceVector<T, N>& list);
template <class Archive, class A, class B>
void exchange(Archive& a, std::pair<A, B>& pair) {
  exchange(a, pair.first);
  exchange(a, pair.second);
}
template <class Archive>
void exchange(Archive& a, std::string& text) {
  std::uint64_t size = text.size();
  a.number(size);
  if constexpr (Archive::reads) {
    if (size > a.most()) return a.fail();
    text.resize(static_cast<std::size_t>(size));
  }
  for (char& c : text) {
    auto byte = static_cast<std::uint8_t>(c);
    a.number(byte);
    c = static_cast<char>(byte);
  }
}
template <class Archive, class Axis, class Value, std::size_t N>
void exchange(Archive& a, StepFunction<Axis, Value, N>& function) {
  exchange(a, function.steps);
}
template <class Archive, class Step>
requires requires(Step& step) {
  step.from;
  step.value;
}
void exchange(Archive& a, Step& step) {
  exchange(a, step.from);
  exchange(a, step.value);
}

template <class Archive, class... Fields>
void fields(Archive& a, Fields&... list) {
  (exchange(a, list), ...);
}

template <class Archive>
void exchange(Archive& a, train::EmergencyStep& s) {
  fields(a, s.A_brake_emergency, s.Kwet_rst, s.Kdry_rst);
}
template <class Archive>
void exchange(Archive& a, train::EmergencyModel& m) {
  fields(a, m.steps, m.with);
}
template <class Archive>
void exchange(Archive& a, train::ServiceModel& m) {
  fields(a, m.A_brake_service, m.with);
}
template <class Archive>
void exchange(Archive& a, train::BuildUpTime& t) {
  fields(a, t.T_brake, t.T_brake_react, t.with);
}
template <class Archive>
void exchange(Archive& a, train::NormalServiceModels& m) {
  fields(a, m.A_brake_normal_service, m.A_SB01, m.A_SB12);
}
template <class Archive>
void exchange(Archive& a, train::TractionSystem& t) {
  fields(a, t.NID_CTRACTION, t.M_VOLTAGE);
}
template <class Archive>
void exchange(Archive& a, train::TrainData& t) {
  fields(a, t.brake_model, t.brake_position, t.brake_percentage, t.emergency, t.service, t.T_emergency, t.T_service,
         t.normal_service, t.normal_service_G, t.Kn_plus, t.Kn_minus, t.regenerative, t.eddy_current, t.magnetic_shoe,
         t.electro_pneumatic, t.regenerative_needs_line_voltage, t.adhesion_independent_brake);
  fields(a, t.T_traction_cut_off, t.traction_cut_off_interface, t.service_brake_interface, t.service_brake_feedback,
         t.L_TRAIN, t.V_MAXTRAIN, t.L_antenna_front, t.M_rotating_nom, t.cant_deficiency_mm, t.other_categories,
         t.axle_load, t.loading_gauge, t.airtight, t.traction_systems, t.axles);
}
template <class Archive>
void exchange(Archive& a, sim::Dynamics& d) {
  fields(a, d.mass_t, d.davis, d.tractive_effort, d.emergency_brake, d.service_brake, d.build_up_s);
}
template <class Archive>
void exchange(Archive& a, sim::Bits& b) {
  std::uint64_t size = b.size;
  fields(a, b.bytes, size);
  b.size = static_cast<std::size_t>(size);
}
template <class Archive>
void exchange(Archive& a, sim::Balise& b) {
  fields(a, b.position_m, b.telegram, b.group, b.index);
}
template <class Archive>
void exchange(Archive& a, sim::TracksideMessage& m) {
  fields(a, m.seq, m.position_m, m.delay_s, m.message, m.index);
}
template <class Archive>
void exchange(Archive& a, sim::GradientSegment& s) {
  fields(a, s.start_m, s.end_m, s.permille);
}
template <class Archive>
void exchange(Archive& a, sim::SpeedSegment& s) {
  fields(a, s.start_m, s.end_m, s.kmh);
}
template <class Archive>
void exchange(Archive& a, sim::Line& l) {
  fields(a, l.name, l.length_m, l.start_front_m, l.end_m, l.start_level, l.start_nid_ntc, l.rbc.contact.NID_C,
         l.rbc.contact.NID_RBC, l.rbc.contact.NID_RADIO, l.rbc.grants_shunting, l.groups, l.balises, l.radio,
         l.absent_messages, l.gradient, l.ssp);
}
template <class Archive>
void exchange(Archive& a, sim::Networks& n) {
  fields(a, n.offered, n.along_line);
}
template <class Archive>
void exchange(Archive& a, Given& g) {
  fields(a, g.line, g.train_name, g.train, g.dynamics, g.train_document, g.networks);
}

template <class Archive, class T>
void exchange(Archive& a, std::vector<T>& list) {
  std::uint64_t size = list.size();
  a.number(size);
  if constexpr (Archive::reads) {
    if (size > a.most()) return a.fail();
    list.resize(static_cast<std::size_t>(size));
  }
  for (T& item : list) exchange(a, item);
}
template <class Archive, class T>
void exchange(Archive& a, std::optional<T>& value) {
  bool there = value.has_value();
  a.number(there);
  if constexpr (Archive::reads) {
    value.reset();
    if (there) value.emplace();
  }
  if (value) exchange(a, *value);
}
template <class Archive, class T, std::size_t N>
void exchange(Archive& a, std::array<T, N>& list) {
  for (T& item : list) exchange(a, item);
}
template <class Archive, class T, std::size_t N>
void exchange(Archive& a, InplaceVector<T, N>& list) {
  std::uint64_t size = list.size();
  a.number(size);
  if constexpr (Archive::reads) {
    if (size > N) return a.fail();
    list.clear();
    T item{};
    for (std::uint64_t i = 0; i < size; ++i)
      if (!list.push_back(item)) return a.fail();
  }
  for (T& item : list) exchange(a, item);
}

}  // namespace

std::string bytes_of(const Given& given) {
  Writer out;
  std::uint32_t version = kVersion;
  Given copy = given;
  exchange(out, version);
  exchange(out, copy);
  return std::move(out.bytes);
}

std::optional<Given> given_of(std::string_view bytes) {
  Reader in(bytes);
  std::uint32_t version = 0;
  Given given;
  exchange(in, version);
  if (version != kVersion) return std::nullopt;
  exchange(in, given);
  if (!in.good() || !in.at_end()) return std::nullopt;
  return given;
}

std::string given_place() {
  std::string place = "@given ";
  for (unsigned digit = 8; digit-- > 0;) place += "0123456789abcdef"[kVersion >> (4 * digit) & 0xFU];
  return place + "@";
}

/// By their bytes, which hold every field.
bool operator==(const Given& a, const Given& b) { return bytes_of(a) == bytes_of(b); }

}  // namespace evc::ride
