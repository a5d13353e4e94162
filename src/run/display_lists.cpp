#include "run/display_lists.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "dmi/dmi.h"
#include "io/number.h"
#include "paint/drawing.h"

namespace evc::run {
namespace {

constexpr std::int64_t kLeast_ms = 1000;       // between two lists
constexpr std::int64_t kMost_ms = 1000 << 15;  // longer than the longest run

/// Writes a list as what is different from the one before (web/src/display_lists.js): numbers behind one another. A
/// shape of its own is its number in the table, counted from 1, with its place, and takes the place of one of the list
/// before; -n stands for the next n of the list before; 0, n goes on in the list before at n places further.
class Differences {
 public:
  Differences(std::string& out, const std::vector<std::uint32_t>& before) : out_(out), before_(before) {
    for (std::size_t i = 0; i < before.size(); ++i) place_of_.emplace(before[i], i);
  }

  /// Whether the shape could be taken from the list before.
  bool take(std::uint32_t stood) {
    if (at_ < before_.size() && before_[at_] == stood) {
      ++taken_;
      ++at_;
      return true;
    }
    const auto found = place_of_.find(stood);
    if (found == place_of_.end()) return false;
    end_run();
    out_ += ",0,";
    io::append_number(out_, static_cast<std::int64_t>(found->second) - static_cast<std::int64_t>(at_));
    at_ = found->second + 1;
    taken_ = 1;
    return true;
  }
  /// One that is not in the list before.
  void put(std::int64_t number, paint::Hundredths at) {
    end_run();
    out_ += ',';
    io::append_number(out_, number);
    out_ += ',';
    paint::append_hundredths(out_, at.x);
    out_ += ',';
    paint::append_hundredths(out_, at.y);
    ++at_;
  }
  void end_run() {
    if (taken_ == 0) return;
    out_ += ',';
    io::append_number(out_, -taken_);
    taken_ = 0;
  }

 private:
  std::string& out_;
  const std::vector<std::uint32_t>& before_;
  std::unordered_map<std::uint32_t, std::size_t> place_of_;
  std::size_t at_ = 0;
  std::int64_t taken_ = 0;
};

}  // namespace

DisplayLists::DisplayLists()
    : state_(std::make_unique<dmi::State>()), before_(std::make_unique<Drawn>()), now_(std::make_unique<Drawn>()) {}
DisplayLists::~DisplayLists() = default;

void DisplayLists::add(std::int64_t t_ms, const kernel::Display& record, const port::DriverActions& done) {
  if (done.has(port::Select::start)) touch_start();
  dmi::show(*state_, record);
  // What the display would send, the driver of the run has done.
  (void)dmi::take(*state_);
  if (!lists_.empty() && t_ms - lists_.back().t_ms < kLeast_ms) return;
  dmi::draw(*state_, record.now, now_->screen);
  std::vector<Stood> stood;
  draw(stood);
  std::swap(before_, now_);
  if (lists_.empty() || stood != lists_.back().stood) lists_.push_back({t_ms, stood});
  stood_before_ = std::move(stood);
}

/// The driver of a run has no fingers: of what he selects, Start alone closes a window, so it is touched (015560 11.3).
void DisplayLists::touch_start() {
  constexpr dmi::Action start{dmi::ActionKind::button, static_cast<std::uint8_t>(Button::start)};
  for (const dmi::Target& target : dmi::targets(*state_)) {
    if (target.action != start) continue;
    const dmi::Cell middle{target.abs.x + target.abs.w / 2, target.abs.y + target.abs.h / 2};
    if (dmi::press(*state_, middle, state_->display.now)) dmi::release(*state_, state_->display.now);
    return;
  }
}

/// Most items are those of the screen before: only the others are painted.
void DisplayLists::draw(std::vector<Stood>& stood) {
  stood.push_back(standing(paint::background()));
  now_->ends.clear();
  std::size_t next = 0;
  for (const dmi::Item& item : now_->screen.items) {
    if (const auto old = before_->find(item, next)) {
      const std::size_t begin = *old == 0 ? 1 : before_->ends[*old - 1];
      for (std::size_t i = begin; i < before_->ends[*old]; ++i) stood.push_back(stood_before_[i]);
      next = *old + 1;
    } else {
      for (const paint::Shape& shape : paint::shapes_of(item))
        if (shape.colour != dmi::Colour::none) stood.push_back(standing(shape));
    }
    now_->ends.push_back(stood.size());
  }
}

/// The place of the same item, looked for from `next` on: what follows one that stayed has mostly stayed too.
std::optional<std::size_t> DisplayLists::Drawn::find(const dmi::Item& item, std::size_t next) const {
  const std::size_t size = ends.size();
  for (std::size_t n = 0; n < size; ++n) {
    const std::size_t i = next + n < size ? next + n : next + n - size;
    if (screen.items[i] == item) return i;
  }
  return std::nullopt;
}

DisplayLists::Stood DisplayLists::standing(const paint::Shape& shape) {
  std::string text;
  paint::append_form(text, shape);
  const auto [form, new_form] = forms_.emplace(std::move(text), static_cast<Form>(form_texts_.size()));
  if (new_form) form_texts_.push_back(&form->first);
  const std::tuple where{form->second, paint::begin_of(shape)};
  const auto [place, new_place] = places_.emplace(where, static_cast<Stood>(place_of_.size()));
  if (new_place) place_of_.push_back(where);
  return place->second;
}

std::string DisplayLists::json(std::size_t most) const {
  for (std::int64_t least_ms = kLeast_ms; least_ms <= kMost_ms; least_ms *= 2) {
    std::string text = json_of(least_ms);
    if (text.size() <= most) return text;
  }
  return R"({"least_s":0,"shapes":[],"lists":[]})";
}

std::string DisplayLists::json_of(std::int64_t least_ms) const {
  std::string shapes, lists;
  std::vector<std::int64_t> numbers(form_texts_.size(), 0);  // in the table, in the order of their first use
  std::int64_t last_number = 0;
  const auto number_of = [&](Form form) {
    if (numbers[form] != 0) return numbers[form];
    if (last_number != 0) shapes += ",\n";
    shapes += '[';
    shapes += *form_texts_[form];
    shapes += ']';
    return numbers[form] = ++last_number;
  };
  const List* before = nullptr;
  const std::vector<Stood> nothing;
  for (const List& list : lists_) {
    if (before != nullptr && list.t_ms - before->t_ms < least_ms) continue;
    if (before != nullptr) lists += ",\n";
    lists += '[';
    io::append_number(lists, static_cast<double>(list.t_ms) / 1000.0);
    Differences differences(lists, before != nullptr ? before->stood : nothing);
    for (const Stood stood : list.stood) {
      if (differences.take(stood)) continue;
      const auto& [form, at] = place_of_[stood];
      differences.put(number_of(form), at);
    }
    differences.end_run();
    lists += ']';
    before = &list;
  }
  std::string out = "{\"least_s\":";
  io::append_number(out, least_ms / 1000);
  return out + ",\"shapes\":[" + shapes + "],\n\"lists\":[" + lists + "]}";
}

}  // namespace evc::run
