#include "cluster/message.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace evc::cluster {
namespace {

using sweep::Range;
using sweep::Row;
using sweep::Value;

std::string random_text(std::mt19937& draw) {
  std::string text(draw() % 40, '\0');
  for (char& c : text) c = static_cast<char>(draw());
  return text;
}

Value random_value(std::mt19937& draw) {
  switch (draw() % 5) {
    case 0:
      return {};
    case 1:
      return static_cast<std::int64_t>((std::uint64_t{draw()} << 32) | draw());
    case 2:
      return std::numeric_limits<double>::denorm_min() * static_cast<double>(draw());
    case 3:
      return static_cast<double>(draw()) / 3.0;
    default:
      return random_text(draw);
  }
}

Row random_row(std::mt19937& draw) {
  Row row;
  row.number = draw();
  for (auto n = draw() % 6; n > 0; --n) row.values.push_back(random_value(draw));
  for (auto n = draw() % 6; n > 0; --n) row.outcome.measures.push_back(random_value(draw));
  if (draw() % 4 == 0) row.outcome.error = random_text(draw);
  return row;
}

bool same(const Row& a, const Row& b) {
  return a.number == b.number && a.values == b.values && a.outcome.measures == b.outcome.measures &&
         a.outcome.error == b.outcome.error;
}

TEST(Message, rows_arrive_as_they_were_sent) {
  std::mt19937 draw(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<Row> rows(draw() % 20);
    for (Row& row : rows) row = random_row(draw);
    std::size_t first = 0;
    const auto back = rows_of(bytes_of(rows, first));
    ASSERT_TRUE(back);
    EXPECT_EQ(first, rows.size());
    ASSERT_EQ(back->size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_TRUE(same((*back)[i], rows[i])) << round << ' ' << i;
  }
}

TEST(Message, many_large_rows_are_several_messages) {
  std::vector<Row> rows(40);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].number = i;
    rows[i].outcome.measures = {std::string(1'000'000, 'x')};
  }
  std::uint64_t next = 0;
  int messages = 0;
  for (std::size_t first = 0; first < rows.size(); ++messages) {
    const std::string bytes = bytes_of(rows, first);
    EXPECT_LT(bytes.size(), 6'000'000U);
    const auto back = rows_of(bytes);
    ASSERT_TRUE(back);
    for (const Row& row : *back) EXPECT_EQ(row.number, next++);
  }
  EXPECT_EQ(next, rows.size());
  EXPECT_GE(messages, 7);
}

// Neither a crash nor memory without bounds: bytes that end too early, or with one of them changed.
TEST(Message, damaged_bytes_are_refused_or_read_to_their_end) {
  std::mt19937 draw(2);
  std::vector<Row> rows(3);
  for (Row& row : rows) row = random_row(draw);
  rows.back().outcome.error = "why";
  std::size_t first = 0;
  const std::string whole = bytes_of(rows, first);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto back = rows_of(whole.substr(0, size));
    EXPECT_TRUE(!back || back->size() < rows.size()) << size;
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0xFF);
    (void)rows_of(changed);
  }
  EXPECT_FALSE(rows_of(whole + '\1'));
}

TEST(Message, the_others_arrive_too) {
  Order order;
  order.what = Order::What::prepare;
  order.spec = "{\"kind\":\"run\"}";
  order.file = "/data/spec.json";
  order.identity = "0123";
  order.version = "1.2";
  order.threads = 7;
  order.exit_code = -3;
  const auto back = order_of(bytes_of(order));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->what, order.what);
  EXPECT_EQ(back->spec, order.spec);
  EXPECT_EQ(back->file, order.file);
  EXPECT_EQ(back->identity, order.identity);
  EXPECT_EQ(back->version, order.version);
  EXPECT_EQ(back->threads, order.threads);
  EXPECT_EQ(back->exit_code, order.exit_code);
  std::string unknown = bytes_of(order);
  unknown[0] = 3;
  EXPECT_FALSE(order_of(unknown));
  EXPECT_FALSE(order_of(""));

  const io::Diagnostic refusal{"f", "/vary/0", "a", "b"};
  EXPECT_EQ(refusal_of(bytes_of(refusal))->text(), refusal.text());
  EXPECT_EQ(count_of(bytes_of(std::uint64_t{1} << 40)), std::uint64_t{1} << 40);
  EXPECT_FALSE(count_of("123"));
  EXPECT_EQ(range_of(bytes_of(Range{3, 9})), (Range{3, 9}));
  EXPECT_FALSE(range_of(bytes_of(Range{9, 3})));
}

}  // namespace
}  // namespace evc::cluster
