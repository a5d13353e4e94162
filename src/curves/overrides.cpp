#include "curves/overrides.h"

#include <utility>

#include "io/curves_file.h"
#include "io/json_pointer.h"

namespace evc::curves {
namespace {

using io::Json;
using io::pointer_of;

/// By its keys with dots between, or a JSON pointer.
std::vector<std::string> tokens_of_place(const std::string& place) {
  if (place.empty() || place.front() == '/') return io::tokens_of(place.empty() ? "/" : place);
  std::vector<std::string> tokens(1);
  for (const char c : place) {
    if (c == '.')
      tokens.emplace_back();
    else
      tokens.back() += c;
  }
  return tokens;
}

[[noreturn]] void leads_nowhere(const Override& o, const std::string& expected) {
  throw io::ReadError{{"--set", pointer_of(o.place, o.place.size()), "a place that leads nowhere", expected}};
}

/// The member or element of `at` that a token names.
Json& below(Json& at, const Override& o, std::size_t i) {
  const std::string here = i == 0 ? "the query" : pointer_of(o.place, i);
  if (at.is_null()) at = Json::object();  // made on the way
  if (at.is_object()) return at[o.place[i]];
  if (!at.is_array()) leads_nowhere(o, here + " to be an object or a list");
  const std::size_t index = io::index_of(o.place[i]);
  if (index >= at.size())
    leads_nowhere(o, "an index of " + here + ", which has " + std::to_string(at.size()) + " elements");
  return at[index];
}

}  // namespace

io::Result<Override> read_override(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string place = text.substr(0, equals);
  Override o;
  if (equals != std::string::npos) o.place = tokens_of_place(place);
  bool empty = o.place.empty() || o.place.size() > io::kDeepestJson;
  for (const std::string& token : o.place) empty = empty || token.empty();
  if (empty)
    return tl::unexpected(
        io::Diagnostic{"--set", "", "\"" + text + "\"", "PLACE=VALUE, as in train.brake_percentage=120"});
  const std::string value = text.substr(equals + 1);
  o.value = Json::parse(value, nullptr, false);
  if (o.value.is_discarded()) {
    o.value = value;
    return o;
  }
  // Keys given twice and deep nesting are refused as in a document.
  return io::guarded([&] {
    o.value = io::parse_json("[" + value + "]", "--set", pointer_of(o.place, o.place.size())).at(0);
    return o;
  });
}

io::Result<io::Json> overridden(std::string_view text, const std::string& file,
                                const std::vector<Override>& overrides) {
  return io::guarded([&] {
    Json document = io::parse_json(text, file);
    for (const Override& o : overrides) {
      const auto member = document.is_object() ? document.find(o.place.front()) : document.end();
      if (o.place.size() > 1 && member != document.end() && member->is_string()) {
        auto in_place = io::curves_document(document.dump(-1, ' ', false, Json::error_handler_t::replace), file);
        if (!in_place) throw io::ReadError{in_place.error()};
        document = *std::move(in_place);
      }
      Json* at = &document;
      for (std::size_t i = 0; i < o.place.size(); ++i) at = &below(*at, o, i);
      *at = o.value;
    }
    return document;
  });
}

}  // namespace evc::curves
