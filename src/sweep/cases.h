#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "random/draws.h"
#include "sweep/spec.h"

namespace evc::sweep {

/// A cell of the table of results: nothing, a whole number, a number, or a text. Lists are texts: JSON.
using Value = std::variant<std::monostate, std::int64_t, double, std::string>;

/// Cell of a JSON value.
Value value_of(const io::Json& json);
Value value_of(const nlohmann::ordered_json& json);

/// From the number of a case to its values.
class Cases {
 public:
  explicit Cases(const Spec& spec);
  /// One value for each entry of `vary`; they depend on the spec and the number alone.
  std::vector<io::Json> values(std::uint64_t number) const;

 private:
  const Spec& spec_;
  random::Sobol sobol_;
};

}  // namespace evc::sweep
