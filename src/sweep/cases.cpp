#include "sweep/cases.h"

#include <algorithm>

namespace evc::sweep {
namespace {

io::Json choice(const Entry& entry, std::uint64_t i) {
  if (entry.how == Entry::How::count) return static_cast<std::int64_t>(i + 1);
  return entry.list[i];
}

/// The value at this share of the distribution.
io::Json drawn(const Entry& entry, double share) {
  if (entry.how == Entry::How::uniform) return entry.first + (entry.second - entry.first) * share;
  // 0 is drawn once in 2^53 times; its quantile would be without an end.
  constexpr double kLeast = 1.0 / 18014398509481984.0;
  if (entry.how == Entry::How::normal)
    return entry.first + entry.second * random::normal_quantile(std::max(share, kLeast));
  const auto choices = entry.choices();
  const auto i = static_cast<std::uint64_t>(share * static_cast<double>(choices));
  return choice(entry, std::min(i, choices - 1));
}

template <class AnyJson>
Value any_value_of(const AnyJson& json) {
  if (json.is_null()) return {};
  if (json.is_number_unsigned() && json.template get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX))
    return json.dump();
  if (json.is_number_integer()) return json.template get<std::int64_t>();
  if (json.is_number_float()) return json.template get<double>();
  if (json.is_string()) return json.template get<std::string>();
  return json.dump(-1, ' ', false, AnyJson::error_handler_t::replace);
}

}  // namespace

Value value_of(const io::Json& json) { return any_value_of(json); }
Value value_of(const nlohmann::ordered_json& json) { return any_value_of(json); }

Cases::Cases(const Spec& spec) : spec_(spec), sobol_(spec.sample == Sample::sobol ? spec.vary.size() : 0) {}

std::vector<io::Json> Cases::values(std::uint64_t number) const {
  std::vector<io::Json> values(spec_.vary.size());
  std::uint64_t rest = number;
  // Of a grid the last entry changes first.
  for (std::size_t i = values.size(); i-- > 0;) {
    const Entry& entry = spec_.vary[i];
    if (spec_.sample == Sample::grid && !entry.is_drawn()) {
      values[i] = choice(entry, rest % entry.choices());
      rest /= entry.choices();
    } else {
      values[i] = drawn(entry, spec_.sample == Sample::sobol
                                   ? sobol_.at(number, i)
                                   : random::uniform_draw(spec_.seed, number, static_cast<std::uint32_t>(i)));
    }
  }
  return values;
}

}  // namespace evc::sweep
