#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "check/rules.h"
#include "io/telegram_json.h"
#include "lang/schema.h"

// The keys of a line file that describe its bits are read by nobody else: any of them may be absent. One of another
// type than that of the bits describes something else.
namespace evc::check {
namespace {

using Json = nlohmann::json;
using enum Severity;

constexpr const char* kLineFile = "docs/line.md";

const Json* find(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto at = object.find(key);
  return at != object.end() ? &*at : nullptr;
}

std::string shown(const Json& value) {
  return value.is_object() ? "an object" : value.is_array() ? "a list" : value.dump(-1, ' ', true);
}

/// The differences of one telegram or message.
class Comparison {
 public:
  Comparison(Findings& out, const Where& where) : out_(out), where_(where) {}

  void number(const Json& object, const char* key, const Json* bits) {
    const Json* given = find(object, key);
    if (given == nullptr || given->is_null() || bits == nullptr) return;
    if (given->is_number_integer())
      values(key, *given, *bits);
    else
      differ(fmt::format("{} {}, the bits have {}", key, shown(*given), bits->dump()));
  }
  void values(const std::string& name, const Json& given, const Json& bits) {
    if (given.is_number_integer() && bits.is_number_integer() && given != bits)
      differ(fmt::format("{} {}, the bits have {}", name, given.dump(), bits.dump()));
  }
  /// The variables of an object, by their names, and of its repetitions.
  void object(const std::string& name, const Json& given, const Json& bits) {
    if (!given.is_object() || !bits.is_object()) return;
    for (const auto& [key, value] : given.items()) {
      const std::string inside = name.empty() ? key : name + " " + key;
      if (value.is_array()) {
        if (const Json* list = only_list(bits)) repetitions(inside, value, *list);
      } else if (const Json* other = find(bits, key.c_str())) {
        values(inside, value, *other);
      }
    }
  }
  void numbers(const std::vector<int>& given, const std::vector<int>& bits) {
    if (given != bits) differ(fmt::format("packets {}, the bits have {}", fmt::join(given, " "), fmt::join(bits, " ")));
  }
  void differ(const std::string& text) { out_.add(error, where_, kLineFile, "the file describes " + text); }

 private:
  /// A packet has one list of repetitions in the form of evc decode; one without elements may have none.
  static const Json* only_list(const Json& bits) {
    const Json* list = nullptr;
    for (const auto& [key, value] : bits.items()) {
      if (!value.is_array() || key == "diffs") continue;
      if (list != nullptr) return nullptr;
      list = &value;
    }
    return list;
  }
  void repetitions(const std::string& name, const Json& given, const Json& bits) {
    if (given.size() != bits.size())
      return differ(fmt::format("{} with {} elements, the bits have {}", name, given.size(), bits.size()));
    for (std::size_t i = 0; i < given.size(); ++i) object(fmt::format("{} {}", name, i), given[i], bits[i]);
  }

  Findings& out_;
  Where where_;
};

std::vector<int> packets_of(const Json& list, const char* key) {
  std::vector<int> numbers;
  for (const Json& packet : list)
    if (const Json* number = find(packet, key); number != nullptr && number->is_number_integer() && *number != 255)
      numbers.push_back(number->get<int>());
  return numbers;
}

/// "12 Level 1 movement authority": the number.
std::vector<int> contained(const Json& list) {
  std::vector<int> numbers;
  for (const Json& text : list) {
    if (!text.is_string()) continue;
    const std::string& name = text.get_ref<const std::string&>();
    int number = 0;
    if (std::from_chars(name.data(), name.data() + name.size(), number).ec == std::errc{}) numbers.push_back(number);
  }
  return numbers;
}

void compare_packets(Comparison& comparison, const Json& given, const Json& bits) {
  const Json* packets = find(bits, "packets");
  if (packets == nullptr) return;
  const std::vector<int> numbers = packets_of(*packets, "NID_PACKET");
  if (const Json* list = find(given, "contains"); list != nullptr && list->is_array())
    comparison.numbers(contained(*list), numbers);
  else if (list != nullptr && !list->is_null())
    comparison.differ("contains " + shown(*list) + ", a list of packets is expected");
  const Json* list = find(given, "packets");
  if (list == nullptr || !list->is_array()) return;
  const std::vector<int> described = packets_of(*list, "nid_packet");
  comparison.numbers(described, numbers);
  if (described != numbers) return;
  std::size_t next = 0;
  for (const Json& packet : *list) {
    const Json* number = find(packet, "nid_packet");
    if (number == nullptr || !number->is_number_integer() || *number == 255) continue;
    if (const Json* fields = find(packet, "fields"))
      comparison.object(fmt::format("packet {}", number->get<int>()), *fields, (*packets)[next]);
    ++next;
  }
}

void check_balise(const Group& group, const Telegram& telegram, const Json& given, const Json& balise, Findings& out) {
  std::string text;
  if (!io::append_balise_json(text, telegram.balise->telegram.bytes, telegram.balise->telegram.size)) return;
  const Json bits = Json::parse(text);
  const Json& header = bits["header"];
  Comparison comparison(out, group.where(telegram));
  comparison.number(given, "nid_c", find(header, "NID_C"));
  comparison.number(given, "nid_bg", find(header, "NID_BG"));
  comparison.number(balise, "n_pig", find(header, "N_PIG"));
  comparison.number(balise, "n_total", find(header, "N_TOTAL"));
  if (const Json* described = find(balise, "header")) comparison.object("", *described, header);
  compare_packets(comparison, balise, bits);
}

void check_group_place(const Group& group, const Json& given, Findings& out) {
  const Json* at = find(given, "position_m");
  if (at == nullptr || at->is_null()) return;
  if (at->is_number() && std::abs(at->get<double>() - group.at_m) < 0.05) return;
  out.add(
      error, group.where(), kLineFile,
      fmt::format("the file describes the group at {} m, its balise N_PIG 0 is at {:.1f} m", shown(*at), group.at_m));
}

void check_message(const Message& message, lang::SystemVersion sv, const Json& given, Findings& out) {
  std::string text;
  if (!io::append_radio_json(text, message.sent->message.bytes, lang::Direction::to_train, sv)) return;
  const Json bits = Json::parse(text);
  Comparison comparison(out, message.where());
  comparison.number(given, "nid_message", find(bits, "NID_MESSAGE"));
  if (const Json* lrbg = find(given, "nid_lrbg"); lrbg != nullptr && message.lrbg) {
    const Json id{{"NID_C", message.lrbg->NID_C}, {"NID_BG", message.lrbg->NID_BG}};
    comparison.object("nid_lrbg", *lrbg, id);
  }
  if (const Json* fields = find(given, "fields")) comparison.object("", *fields, bits);
  compare_packets(comparison, given, bits);
}

}  // namespace

void check_document(const Trackside& trackside, const Json& document, Findings& out) {
  const Json& groups = document.at("balise_groups");
  for (const Group& group : trackside.groups) {
    const Json& given = groups.at(group.index);
    check_group_place(group, given, out);
    for (const Telegram& telegram : group.telegrams)
      if (telegram.view.fault == lang::Fault::none)
        check_balise(group, telegram, given, given.at("balises").at(telegram.balise->index), out);
  }
  for (const Message& message : trackside.messages)
    if (message.view.fault == lang::Fault::none)
      check_message(message, message.view.sv, document.at("rbc_messages").at(message.sent->index), out);
}

}  // namespace evc::check
