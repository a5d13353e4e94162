#pragma once
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/diagnostic.h"
#include "terms/clause.h"
#include "terms/row.h"

namespace evc::io {

using Json = nlohmann::json;

/// Arrays and objects in one another, at most: more than any file of the program needs.
inline constexpr std::size_t kDeepestJson = 64;

/// Parses a JSON text. A key given twice in one object and nesting beyond kDeepestJson are errors. Errors name line and
/// column, or the JSON pointer. Throws ReadError.
Json parse_json(std::string_view text, const std::string& file, const std::string& where = "");

/// The `schema` of a document; empty where the text is no JSON object with one.
std::string schema_of(std::string_view text);
/// What a file of that schema is for; empty for an unknown one.
std::string use_of(const std::string& schema);
/// The schema in quotation marks, with what the file is for.
std::string quoted_kind(const std::string& schema);

/// A place in a JSON document, with the pointer that leads there. Every accessor throws ReadError
/// with that pointer when the value is not of the wanted kind.
class JsonPlace {
 public:
  JsonPlace(const Json& root, std::string file, std::string prefix = "")
      : value_(&root), file_(std::move(file)), prefix_(std::move(prefix)) {}

  const Json& value() const { return *value_; }
  const std::string& file() const { return file_; }

  bool is_object() const { return value_->is_object(); }
  bool is_array() const { return value_->is_array(); }
  bool is_string() const { return value_->is_string(); }
  bool is_null() const { return value_->is_null(); }

  /// The member `key` of this object; an error when it is absent.
  JsonPlace operator[](std::string_view key) const;
  /// The same, `nullopt` when absent.
  std::optional<JsonPlace> find(std::string_view key) const;
  /// Element `i` of this array; an error when it is absent.
  JsonPlace operator[](std::size_t i) const;
  std::size_t size() const;

  /// Rejects keys that are not in `known` (a misspelt key must not be ignored silently).
  void know_only(std::initializer_list<const char*> known) const;

  double number() const;
  /// Outside the range an error, with the clause of SUBSET-026 that gives it.
  double number(double least, double most, Clause clause = {}) const;
  std::int64_t integer(std::int64_t least, std::int64_t most, Clause clause = {}) const;
  bool boolean() const;
  const std::string& string() const;
  /// The index of this string in `names`; an error listing them otherwise.
  std::size_t one_of(std::initializer_list<const char*> names) const;
  std::size_t one_of(std::span<const char* const> names) const;
  /// The term with this name in a table of src/terms.
  template <const auto& kRows>
  auto term() const {
    return kRows[one_of(std::span<const char* const>(terms::kNames<kRows>))].value;
  }
  /// The bytes of this string of hexadecimal digits.
  std::vector<std::uint8_t> hex() const;
  /// Requires `"schema": name` in this object.
  void require_schema(const char* name) const;

  [[noreturn]] void fail(std::string expected) const;
  [[noreturn]] void fail(std::string found, std::string expected) const;

 private:
  JsonPlace child(const Json& value, std::string_view key) const;
  std::string pointer() const;

  const Json* value_;
  std::string file_;
  std::string prefix_;  // "line 7", or empty
  std::string pointer_;
};

/// A key as a reference token of a JSON pointer: "~" and "/" inside it escaped (RFC 6901).
std::string reference_token(std::string_view key);

/// " (SUBSET-026 3.13.2)", or nothing without a clause.
std::string of_clause(Clause clause);

}  // namespace evc::io
