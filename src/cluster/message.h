#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/diagnostic.h"
#include "sweep/queue.h"

// What ranks send one another, as bytes and back. All of them are the same program on computers of one kind: numbers
// are as they are in memory. Bytes that are not of the kind asked for give nothing.
namespace evc::cluster {

/// From rank 0 to all: what comes next.
struct Order {
  enum class What : std::uint8_t {
    prepare,  ///< have the plan of this spec, and say whether that is so
    compute,  ///< its cases, as they are granted
    finish    ///< with this status
  };
  What what = What::finish;
  std::string spec;           ///< its text
  std::string file;           ///< its name
  std::string identity;       ///< of the plan that rank 0 has
  std::string version;        ///< of the program
  std::uint32_t threads = 1;  ///< of each rank
  std::int32_t exit_code = 0;
};
std::string bytes_of(const Order& order);
std::optional<Order> order_of(std::string_view bytes);

/// Why a rank cannot have the plan.
std::string bytes_of(const io::Diagnostic& refusal);
std::optional<io::Diagnostic> refusal_of(std::string_view bytes);

std::string bytes_of(std::uint64_t count);
std::optional<std::uint64_t> count_of(std::string_view bytes);

std::string bytes_of(const sweep::Range& range);
std::optional<sweep::Range> range_of(std::string_view bytes);

/// Rows from the one at `first`, as many as make a message of a moderate size, at least one; `first` is behind them
/// then.
std::string bytes_of(const std::vector<sweep::Row>& rows, std::size_t& first);
std::optional<std::vector<sweep::Row>> rows_of(std::string_view bytes);

}  // namespace evc::cluster
