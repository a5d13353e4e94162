#include <algorithm>

#include "io/json.h"

// The parser alone: the library of the language reads JSON without the rest of this room.
namespace evc::io {
namespace {

/// At most `most` bytes of a text from `at`, without the beginning of a UTF-8 character at their end.
std::string excerpt(std::string_view text, std::size_t at, std::size_t most) {
  std::size_t end = std::min(at + most, text.size());
  const auto continues = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0u) == 0x80u; };
  std::size_t start = end;
  while (start > at && start < text.size() && end - start < 3 && continues(start)) --start;
  return std::string(text.substr(at, start > at ? start - at : end - at));
}

/// Builds a document while it is parsed.
class Builder {
 public:
  using Exception = nlohmann::detail::exception;

  Builder(std::string_view text, const std::string& file, const std::string& where)
      : text_(text), file_(file), where_(where) {}
  Json take() { return std::move(root_); }

  bool null() { return value(nullptr); }
  bool boolean(bool v) { return value(v); }
  bool number_integer(Json::number_integer_t v) { return value(v); }
  bool number_unsigned(Json::number_unsigned_t v) { return value(v); }
  bool number_float(Json::number_float_t v, const std::string&) { return value(v); }
  bool string(std::string& v) { return value(std::move(v)); }
  bool binary(Json::binary_t& v) { return value(std::move(v)); }
  bool start_object(std::size_t) { return open(Json::value_t::object); }
  bool start_array(std::size_t) { return open(Json::value_t::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(const std::string& name) {
    const auto [member, is_new] = open_.back()->get_ref<Json::object_t&>().emplace(name, nullptr);
    member_ = &member->second;
    if (!is_new) fail(at_pointer(pointer() + "/" + reference_token(name)), "a key given twice", "each key once");
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const Exception& e) {
    // 406: a number beyond the range of a double; the position is behind it.
    const bool number = e.id == 406;
    const std::size_t back = number ? token.size() : 1;
    const std::size_t at = std::min(position < back ? 0 : position - back, text_.size());
    const std::string_view before = text_.substr(0, at);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    const std::string column = "column " + std::to_string(at - start + 1);
    std::string found = "the end of the text";
    if (at < text_.size()) found = number ? "a number out of range" : "\"" + excerpt(text_, at, 20) + "\"";
    fail(where_.empty() ? "line " + std::to_string(line) + " " + column : where_ + " " + column, found, "JSON");
  }

 private:
  /// Puts a value where the next one belongs.
  template <class Value>
  Json* place(Value&& v) {
    Json* const to = open_.empty() ? &root_ : member_;
    if (!open_.empty() && open_.back()->is_array())
      return &open_.back()->get_ref<Json::array_t&>().emplace_back(std::forward<Value>(v));
    *to = Json(std::forward<Value>(v));
    return to;
  }
  template <class Value>
  bool value(Value&& v) {
    (void)place(std::forward<Value>(v));
    return true;
  }
  bool open(Json::value_t kind) {
    if (open_.size() == kDeepestJson) {
      const std::string most = std::to_string(kDeepestJson);
      fail(at_pointer(pointer()), "more than " + most + " arrays and objects in one another", "at most " + most);
    }
    open_.push_back(place(kind));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }
  /// The place of the innermost open array or object.
  std::string pointer() const {
    std::string all;
    for (std::size_t i = 1; i < open_.size(); ++i) {
      const Json& outer = *open_[i - 1];
      if (outer.is_array()) {
        all += "/" + std::to_string(outer.size() - 1);
        continue;
      }
      for (const auto& [name, inner] : outer.get_ref<const Json::object_t&>())
        if (&inner == open_[i]) all += "/" + reference_token(name);
    }
    return all;
  }
  std::string at_pointer(const std::string& pointer) const {
    return where_.empty() || pointer.empty() ? where_ + pointer : where_ + " " + pointer;
  }
  [[noreturn]] void fail(std::string where, std::string found, std::string expected) const {
    throw ReadError{{file_, std::move(where), std::move(found), std::move(expected)}};
  }

  std::string_view text_;
  const std::string& file_;
  const std::string& where_;
  Json root_;
  std::vector<Json*> open_;  // from the root to the innermost array or object
  Json* member_ = nullptr;   // of the key read last
};

}  // namespace

std::string reference_token(std::string_view key) {
  std::string out;
  for (const char c : key) {
    if (c == '~')
      out += "~0";
    else if (c == '/')
      out += "~1";
    else
      out += c;
  }
  return out;
}

Json parse_json(std::string_view text, const std::string& file, const std::string& where) {
  Builder builder(text, file, where);
  (void)Json::sax_parse(text, &builder);  // every error is thrown
  return builder.take();
}

std::string schema_of(std::string_view text) {
  try {
    const Json document = parse_json(text, "");
    const auto schema = document.find("schema");
    return document.is_object() && schema != document.end() && schema->is_string() ? schema->get<std::string>() : "";
  } catch (const ReadError&) {
    return "";
  }
}

}  // namespace evc::io
