#include "cluster/message.h"

#include <cstring>
#include <type_traits>
#include <variant>

namespace evc::cluster {
namespace {

using sweep::Range;
using sweep::Row;
using sweep::Value;

/// Far below the 2 GiB that a message of MPI may have.
constexpr std::size_t kModerate = std::size_t{4} << 20;

class Writer {
 public:
  template <class Number>
  void number(Number n) {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    char raw[sizeof n];
    std::memcpy(raw, &n, sizeof n);
    bytes_.append(raw, sizeof n);
  }
  void text(const std::string& text) {
    number<std::uint64_t>(text.size());
    bytes_ += text;
  }
  void value(const Value& value) {
    number(static_cast<std::uint8_t>(value.index()));
    if (const auto* whole = std::get_if<std::int64_t>(&value)) number(*whole);
    if (const auto* real = std::get_if<double>(&value)) number(*real);
    if (const auto* given = std::get_if<std::string>(&value)) text(*given);
  }
  void values(const std::vector<Value>& values) {
    number<std::uint64_t>(values.size());
    for (const Value& v : values) value(v);
  }
  std::size_t size() const { return bytes_.size(); }
  std::string bytes() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// After the first fault everything is 0 and empty.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  template <class Number>
  Number number() {
    Number n{};
    const std::string_view raw = take(sizeof n);
    if (raw.size() == sizeof n) std::memcpy(&n, raw.data(), sizeof n);
    return n;
  }
  std::string text() { return std::string(take(number<std::uint64_t>())); }
  Value value() {
    switch (number<std::uint8_t>()) {
      case 0:
        return {};
      case 1:
        return number<std::int64_t>();
      case 2:
        return number<double>();
      case 3:
        return text();
      default:
        good_ = false;
        return {};
    }
  }
  std::vector<Value> values() {
    std::vector<Value> values;
    // Each takes a byte at least: a number that cannot be true asks for no memory.
    for (auto n = number<std::uint64_t>(); n > 0 && good_; --n) values.push_back(value());
    return values;
  }
  bool more() const { return good_ && !rest_.empty(); }
  /// Everything was there, and nothing else.
  bool whole() const { return good_ && rest_.empty(); }

 private:
  std::string_view take(std::uint64_t size) {
    good_ = good_ && size <= rest_.size();
    if (!good_) return {};
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }
  std::string_view rest_;
  bool good_ = true;
};

template <class T>
std::optional<T> if_whole(const Reader& in, T value) {
  return in.whole() ? std::optional(std::move(value)) : std::nullopt;
}

}  // namespace

std::string bytes_of(const Order& order) {
  Writer out;
  out.number(order.what);
  for (const std::string* text : {&order.spec, &order.file, &order.identity, &order.version}) out.text(*text);
  out.number(order.threads);
  out.number(order.exit_code);
  return std::move(out).bytes();
}

std::optional<Order> order_of(std::string_view bytes) {
  Reader in(bytes);
  Order order;
  order.what = in.number<Order::What>();
  if (order.what > Order::What::finish) return std::nullopt;
  for (std::string* text : {&order.spec, &order.file, &order.identity, &order.version}) *text = in.text();
  order.threads = in.number<std::uint32_t>();
  order.exit_code = in.number<std::int32_t>();
  return if_whole(in, std::move(order));
}

std::string bytes_of(const io::Diagnostic& refusal) {
  Writer out;
  for (const std::string* text : {&refusal.file, &refusal.where, &refusal.found, &refusal.expected}) out.text(*text);
  return std::move(out).bytes();
}

std::optional<io::Diagnostic> refusal_of(std::string_view bytes) {
  Reader in(bytes);
  io::Diagnostic refusal;
  for (std::string* text : {&refusal.file, &refusal.where, &refusal.found, &refusal.expected}) *text = in.text();
  return if_whole(in, std::move(refusal));
}

std::string bytes_of(std::uint64_t count) {
  Writer out;
  out.number(count);
  return std::move(out).bytes();
}

std::optional<std::uint64_t> count_of(std::string_view bytes) {
  Reader in(bytes);
  const auto count = in.number<std::uint64_t>();
  return if_whole(in, count);
}

std::string bytes_of(const Range& range) {
  Writer out;
  out.number(range.first);
  out.number(range.end);
  return std::move(out).bytes();
}

std::optional<Range> range_of(std::string_view bytes) {
  Reader in(bytes);
  Range range;
  range.first = in.number<std::uint64_t>();
  range.end = in.number<std::uint64_t>();
  if (range.first > range.end) return std::nullopt;
  return if_whole(in, range);
}

std::string bytes_of(const std::vector<Row>& rows, std::size_t& first) {
  Writer out;
  while (first < rows.size() && out.size() < kModerate) {
    const Row& row = rows[first++];
    out.number(row.number);
    out.values(row.values);
    out.values(row.outcome.measures);
    out.text(row.outcome.error);
  }
  return std::move(out).bytes();
}

std::optional<std::vector<Row>> rows_of(std::string_view bytes) {
  Reader in(bytes);
  std::vector<Row> rows;
  while (in.more()) {
    Row& row = rows.emplace_back();
    row.number = in.number<std::uint64_t>();
    row.values = in.values();
    row.outcome.measures = in.values();
    row.outcome.error = in.text();
  }
  return if_whole(in, std::move(rows));
}

}  // namespace evc::cluster
