#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "driver/driver.h"
#include "port/event.h"
#include "port/inputs.h"
#include "terms/clause.h"
#include "terms/requests.h"
#include "terms/what.h"
#include "train/brake_model.h"

// The texts and names of the kernel's inputs and outputs, for user interfaces and files. No kernel room links them.
namespace evc::texts {

/// The meaning of the numbers of an event.
enum class Takes : std::uint8_t {
  nothing,
  id,       ///< `id` is printed as it is
  modes,    ///< `from` and `to` are modes, `id` the condition
  levels,   ///< `from` and `to` are levels
  select,   ///< `id` is a Select
  entered,  ///< `id` is an Entered
  ack,      ///< `id` is an Ack
  version,  ///< `id` is an M_VERSION
  fault,    ///< `id` is a train::Fault
  gap       ///< `id` is an EditionGap
};
/// How an event is printed: "SUBJECT id from->to text [clause]".
struct EventText {
  What what;
  const char* subject;
  Takes takes;
  const char* text;                    ///< null if the numbers are the whole text
  const char* after_clause = nullptr;  ///< inside the brackets of the clause
};
const EventText& text_of(What what);

/// A short text without heap.
class ShortText {
 public:
  static constexpr std::size_t kMost = 127;

  /// What does not fit is left out.
  void add(std::string_view text) noexcept;
  void add(std::int64_t number) noexcept;
  std::string_view view() const noexcept { return {characters_.data(), size_}; }

 private:
  std::array<char, kMost> characters_{};
  std::size_t size_ = 0;
};
/// "SUBJECT what [clause or condition]", whole for every event.
ShortText line_of(const port::Event& event) noexcept;

/// "5.8.4.1 h", "4.8.3 [4]"; empty for none.
std::string text_of(Clause clause);

/// The names of inputs in JSON, in the order of their enumerations.
extern const std::array<const char*, static_cast<std::size_t>(port::Select::count)> kSelectNames;
extern const std::array<const char*, 3> kDirectionNames;  ///< DirectionController
extern const std::array<const char*, 2> kCabNames;        ///< Cab
extern const std::array<const char*, static_cast<std::size_t>(port::Window::count)> kWindowNames;

/// The text of an event for what the driver selected or entered.
const char* words_of(port::Select select);
const char* words_of(port::Entered entered);
/// "brake_percentage".
const char* name(train::Fault fault);

/// The keys of `select` and `enter` that stand for an input of 4.7.2; null where there is none (acknowledgements stand
/// in `driver.requests`) or fewer.
using InputKeys = std::array<const char*, 3>;
InputKeys keys_of(DriverInput input);

}  // namespace evc::texts
