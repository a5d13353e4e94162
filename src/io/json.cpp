#include "io/json.h"
#include "texts/texts.h"

#include <algorithm>
#include <cmath>

namespace evc::io {
namespace {

/// The value as in the file, shortened.
std::string shown(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

}  // namespace

std::string JsonPlace::pointer() const {
  if (prefix_.empty()) return pointer_.empty() ? "/" : pointer_;
  return pointer_.empty() ? prefix_ : prefix_ + " " + pointer_;
}

void JsonPlace::fail(std::string found, std::string expected) const {
  throw ReadError{{file_, pointer(), std::move(found), std::move(expected)}};
}

void JsonPlace::fail(std::string expected) const { fail(shown(*value_), std::move(expected)); }

JsonPlace JsonPlace::child(const Json& value, std::string_view key) const {
  JsonPlace place(value, file_, prefix_);
  place.pointer_ = pointer_ + "/" + reference_token(key);
  return place;
}

std::optional<JsonPlace> JsonPlace::find(std::string_view key) const {
  if (!value_->is_object()) fail("an object");
  const auto it = value_->find(key);
  if (it == value_->end()) return std::nullopt;
  return child(*it, key);
}

JsonPlace JsonPlace::operator[](std::string_view key) const {
  auto place = find(key);
  if (!place) fail("no key \"" + std::string(key) + "\"", "one");
  return *place;
}

JsonPlace JsonPlace::operator[](std::size_t i) const {
  if (!value_->is_array()) fail("an array");
  if (i >= value_->size()) fail("an array of more than " + std::to_string(i));
  return child((*value_)[i], std::to_string(i));
}

std::size_t JsonPlace::size() const {
  if (!value_->is_array()) fail("an array");
  return value_->size();
}

void JsonPlace::know_only(std::initializer_list<const char*> known) const {
  if (!value_->is_object()) fail("an object");
  for (const auto& [key, value] : value_->items()) {
    const bool is_known = std::any_of(known.begin(), known.end(), [&key = key](const char* k) { return key == k; });
    if (is_known) continue;
    std::string list;
    for (const char* k : known) list += (list.empty() ? "" : ", ") + std::string(k);
    child(value, key).fail("an unknown key", "one of " + list);
  }
}

std::string of_clause(Clause clause) { return clause ? " (SUBSET-026 " + texts::text_of(clause) + ")" : std::string(); }

double JsonPlace::number() const {
  if (!value_->is_number()) fail("a number");
  const auto v = value_->get<double>();
  if (!std::isfinite(v)) fail("a finite number");
  return v;
}

double JsonPlace::number(double least, double most, Clause clause) const {
  const double v = number();
  if (!(v >= least && v <= most))
    fail("a number from " + Json(least).dump() + " to " + Json(most).dump() + of_clause(clause));
  return v;
}

std::int64_t JsonPlace::integer(std::int64_t least, std::int64_t most, Clause clause) const {
  const std::string wanted =
      "an integer from " + std::to_string(least) + " to " + std::to_string(most) + of_clause(clause);
  if (!value_->is_number_integer()) fail(wanted);
  if (value_->is_number_unsigned() && value_->get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX))
    fail(wanted);
  const auto v = value_->get<std::int64_t>();
  if (v < least || v > most) fail(wanted);
  return v;
}

bool JsonPlace::boolean() const {
  if (!value_->is_boolean()) fail("true or false");
  return value_->get<bool>();
}

const std::string& JsonPlace::string() const {
  if (!value_->is_string()) fail("a string");
  return value_->get_ref<const std::string&>();
}

std::size_t JsonPlace::one_of(std::initializer_list<const char*> names) const {
  return one_of(std::span<const char* const>(names.begin(), names.size()));
}

std::size_t JsonPlace::one_of(std::span<const char* const> names) const {
  const auto it = std::find_if(names.begin(), names.end(), [this](const char* n) { return *value_ == n; });
  if (it != names.end()) return static_cast<std::size_t>(it - names.begin());
  std::string list;
  for (const char* n : names) list += (list.empty() ? "\"" : ", \"") + std::string(n) + '"';
  fail("one of " + list);
}

std::vector<std::uint8_t> JsonPlace::hex() const {
  const std::string& digits = string();
  if (digits.empty()) fail("hexadecimal digits");
  std::vector<std::uint8_t> bytes((digits.size() + 1) / 2);
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const int d = hex_digit(digits[i]);
    if (d < 0) fail("\"" + std::string(1, digits[i]) + "\" at digit " + std::to_string(i + 1), "hexadecimal digits");
    bytes[i / 2] = static_cast<std::uint8_t>(bytes[i / 2] | (i % 2 == 0 ? d << 4 : d));
  }
  return bytes;
}

void JsonPlace::require_schema(const char* name) const {
  const auto schema = find("schema");
  if (!schema) fail("no key \"schema\"", "\"schema\": \"" + std::string(name) + "\"");
  if (schema->string() != name) schema->fail(quoted_kind(schema->string()), "\"" + std::string(name) + "\"");
}

std::string use_of(const std::string& schema) {
  struct Kind {
    const char* schema;
    const char* use;
  };
  static constexpr Kind kinds[] = {{"etcs-line/1", "a line: evc run drives it"},
                                   {"evc-line-description/1", "a description: evc make-line encodes it"},
                                   {"evc-curves/1", "a query: evc curves answers it"},
                                   {"etcs-train/1", "a train: evc run --train reads it"},
                                   {"evc-persistent/1", "what a unit kept: evc replay --persistent reads it"},
                                   {"evc-telegram/1", "a telegram: evc encode encodes it"},
                                   {"evc-summary/1", "the summary of a run"},
                                   {"evc-sweep/1", "a sweep: evc sweep computes its cases"},
                                   {"evc-brakes/1", "brake units: evc brakes computes the deceleration"}};
  for (const Kind& kind : kinds)
    if (schema == kind.schema) return kind.use;
  return "";
}

std::string quoted_kind(const std::string& schema) {
  const std::string use = use_of(schema);
  return "\"" + schema + (use.empty() ? "\"" : "\" (" + use + ")");
}

}  // namespace evc::io
