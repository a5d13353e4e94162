#include "io/outputs_diff.h"

#include <algorithm>

#include "io/json.h"

namespace evc::io {
namespace {

constexpr const char* kNothing = "nothing";

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

const Json* member(const Json& object, const std::string& key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::string shown(const Json* value) { return value == nullptr ? kNothing : value->dump(); }

// NOLINTNEXTLINE(misc-no-recursion): as deep as the JSON is, which the parser bounds.
void compare(const Json* a, const Json* b, const std::string& pointer, std::vector<FieldDifference>& out) {
  if (a != nullptr && b != nullptr) {
    if (*a == *b) return;
    if (a->is_object() && b->is_object()) {
      for (const auto& item : a->items())
        compare(&item.value(), member(*b, item.key()), pointer + "/" + reference_token(item.key()), out);
      for (const auto& item : b->items())
        if (!a->contains(item.key())) compare(nullptr, &item.value(), pointer + "/" + reference_token(item.key()), out);
      return;
    }
    if (a->is_array() && b->is_array()) {
      for (std::size_t i = 0; i < std::max(a->size(), b->size()); ++i)
        compare(i < a->size() ? &(*a)[i] : nullptr, i < b->size() ? &(*b)[i] : nullptr,
                pointer + "/" + std::to_string(i), out);
      return;
    }
  }
  out.push_back({pointer, shown(a), shown(b)});
}

}  // namespace

Result<std::optional<StreamDifference>> difference(std::string_view a, const std::string& name_a, std::string_view b,
                                                   const std::string& name_b) {
  return guarded([&]() -> std::optional<StreamDifference> {
    const auto lines_a = split(a), lines_b = split(b);
    const std::size_t both = std::min(lines_a.size(), lines_b.size());
    StreamDifference d;
    d.lines_a = lines_a.size();
    d.lines_b = lines_b.size();
    d.differing = std::max(lines_a.size(), lines_b.size()) - both;
    for (std::size_t i = both; i-- > 0;)
      if (lines_a[i] != lines_b[i]) {
        ++d.differing;
        d.line = i + 1;
      }
    if (d.differing == 0) return std::nullopt;
    if (d.line == 0) {
      d.line = both + 1;
      return d;
    }
    const std::string where = "line " + std::to_string(d.line);
    const Json left = parse_json(lines_a[d.line - 1], name_a, where);
    const Json right = parse_json(lines_b[d.line - 1], name_b, where);
    if (const Json* t = left.is_object() ? member(left, "t_ms") : nullptr; t != nullptr) d.t_ms = t->dump();
    compare(&left, &right, "", d.fields);
    return d;
  });
}

std::string text_of(const StreamDifference& d, const std::string& name_a, const std::string& name_b) {
  std::string text = name_a + " and " + name_b + " differ first in line " + std::to_string(d.line);
  if (d.t_ms) text += ", t_ms " + *d.t_ms;
  text += "\n";
  if (d.line > std::min(d.lines_a, d.lines_b))
    text += "  " + (d.lines_a < d.lines_b ? name_a : name_b) + " ends before it\n";
  else if (d.fields.empty())
    text += "  the values are the same, only their notation differs\n";
  for (const FieldDifference& f : d.fields)
    text += "  " + (f.pointer.empty() ? "the line" : f.pointer) + ": " + f.a + " | " + f.b + "\n";
  return text + std::to_string(d.differing) + " lines differ of " + std::to_string(d.lines_a) + " | " +
         std::to_string(d.lines_b) + "\n";
}

}  // namespace evc::io
