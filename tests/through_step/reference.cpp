#include "reference.h"

#include <algorithm>
#include <fstream>
#include <set>
#include <stdexcept>

#include "base/test_paths.h"

namespace evc::through_step {
namespace {

/// NAME == 1 || NAME == 2, NAME != 0.
struct Test {
  std::string name;
  bool equal = true;
  std::vector<std::uint64_t> codes;
  explicit Test(const std::string& text) {
    std::size_t at = 0;
    while (at < text.size()) {
      const std::size_t space = text.find(' ', at);
      name = text.substr(at, space - at);
      equal = text[space + 1] == '=';
      codes.push_back(std::stoull(text.substr(space + 4)));
      const std::size_t next = text.find(" || ", at);
      at = next == std::string::npos ? text.size() : next + 4;
    }
  }
  bool operator()(std::uint64_t code) const {
    return (std::find(codes.begin(), codes.end(), code) != codes.end()) == equal;
  }
  std::uint64_t one() const { return equal ? codes[0] : codes[0] + 1; }
};

std::string name_of(const Json& element) { return element.value("as", element.at("var").get<std::string>()); }

bool is_known(const std::vector<Field>& fields, const std::string& path) {
  return std::any_of(fields.begin(), fields.end(), [&](const Field& f) { return f.path == path; });
}
bool is_known(const Codes& codes, const std::string& path) { return codes.find(path) != codes.end(); }
/// The path of a name in a group or in those around it; `scope` ends with a slash.
template <class Known>
std::string path_of(const Known& known, std::string scope, const std::string& name) {
  while (!scope.empty() && !is_known(known, scope + name)) {
    const std::size_t slash = scope.rfind('/', scope.size() - 2);
    scope.resize(slash == std::string::npos ? 0 : slash + 1);
  }
  return scope + name;
}

void collect(std::vector<Field>& to, const Json& elements, const std::string& scope, const Codes& needs) {
  for (const Json& e : elements) {
    if (e.contains("var")) {
      to.push_back({scope + name_of(e), e.at("var"), needs});
    } else if (e.contains("if")) {
      const Test test(e.at("if"));
      Codes more = needs;
      more[path_of(to, scope, test.name)] = test.one();
      collect(to, e.at("then"), scope, more);
    } else if (e.contains("repeat")) {
      const std::string counter = scope + e.at("repeat").get<std::string>();
      for (Field& f : to) f.counter = f.counter || f.path == counter;
      Codes more = needs;
      more[counter] = 1;
      collect(to, e.at("body"), scope + e.at("name").get<std::string>() + "/", more);
    }
  }
}

class Writer {
 public:
  Writer(BitList& to, const Codes& codes) : to_(to), codes_(codes) {}
  void put(const Json& elements) {
    Codes seen;
    put(elements, "", seen);
  }
  std::size_t length_at = 0;

 private:
  void put(const Json& elements, const std::string& scope, Codes& seen) {
    for (const Json& e : elements) {
      if (e.contains("var")) {
        const std::string key = e.at("var"), name = name_of(e);
        if (key == "L_PACKET" || key == "L_MESSAGE") length_at = to_.size();
        const auto given = codes_.find(scope + name);
        seen[name] = given != codes_.end() ? given->second : usual(key, name);
        to_.put(seen[name], variable(key).at("bits"));
      } else if (e.contains("if")) {
        const Test test(e.at("if"));
        if (test(seen.at(test.name))) put(e.at("then"), scope, seen);
      } else if (e.contains("repeat")) {
        const std::uint64_t n = seen.at(e.at("repeat"));
        for (std::uint64_t i = 0; i < n; ++i) {
          Codes inner = seen;  // inner names hide outer ones
          put(e.at("body"), scope + e.at("name").get<std::string>() + "/", inner);
        }
      } else if (e.contains("rest_of_packet")) {
        to_.put(0xA5, 8);
      }
    }
  }
  BitList& to_;
  const Codes& codes_;
};

class Reader {
 public:
  Reader(const std::vector<std::uint8_t>& bytes, std::size_t at) : bytes_(bytes), at_(at) {}
  std::uint64_t get(unsigned bits) {
    std::uint64_t code = 0;
    for (unsigned i = 0; i < bits; ++i, ++at_)
      code = code << 1 | (at_ / 8 < bytes_.size() ? (bytes_[at_ / 8] >> (7 - at_ % 8)) & 1u : 0u);
    return code;
  }
  void read(const Json& elements, const std::string& scope, Codes& to) {
    for (const Json& e : elements) {
      if (e.contains("var")) {
        to[scope + name_of(e)] = get(variable(e.at("var")).at("bits"));
      } else if (e.contains("if")) {
        const Test test(e.at("if"));
        if (test(to.at(path_of(to, scope, test.name)))) read(e.at("then"), scope, to);
      } else if (e.contains("repeat")) {
        const std::uint64_t n = to.at(scope + e.at("repeat").get<std::string>());
        for (std::uint64_t i = 0; i < n; ++i)
          read(e.at("body"), scope + e.at("name").get<std::string>() + "/" + std::to_string(i) + "/", to);
      }
    }
  }
  std::size_t at() const { return at_; }

 private:
  const std::vector<std::uint8_t>& bytes_;
  std::size_t at_;
};

const Json* find(const char* file, const char* list, unsigned id, const std::string& sv) {
  for (const Json& p : reference(file).at(list)) {
    const Json& versions = p.at("sv");
    if (p.at("id") == id && std::find(versions.begin(), versions.end(), sv) != versions.end()) return &p;
  }
  return nullptr;
}

}  // namespace

const Json& reference(const std::string& name) {
  static std::map<std::string, Json> all;
  const auto known = all.find(name);
  if (known != all.end()) return known->second;
  std::ifstream file(evc::test::source_folder() + "/tests/reference/" + name + ".json");
  return all[name] = Json::parse(file);
}

const Json& variable(const std::string& key) { return reference("variables").at("variables").at(key); }

std::uint64_t all_ones(unsigned bits) { return bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1; }

bool is_spare(const Json& v, std::uint64_t code) {
  for (const Json& r : v.at("spare"))
    if (code >= r[0].get<std::uint64_t>() && code <= r[1].get<std::uint64_t>()) return true;
  return false;
}

std::vector<std::uint64_t> codes_of(const Json& v) {
  const unsigned bits = v.at("bits");
  std::set<std::uint64_t> codes;
  if (v.at("signed")) {
    codes = {0, all_ones(bits - 1), all_ones(bits - 1) + 1};  // the greatest and the least, 7.3.2.7
  } else {
    codes = {v.at("min").get<std::uint64_t>(), v.at("max").get<std::uint64_t>()};
  }
  for (const char* list : {"special", "enum", "table"})
    if (v.contains(list))
      for (const auto& [code, meaning] : v.at(list).items()) codes.insert(std::stoull(code));
  if (v.at("kind") == "bitset")
    for (unsigned bit = 0; bit < bits; ++bit) codes.insert(std::uint64_t{1} << bit);
  std::vector<std::uint64_t> out;
  for (const std::uint64_t code : codes)
    if (!is_spare(v, code)) out.push_back(code);
  return out;
}

std::vector<std::uint64_t> spare_codes_of(const Json& v) {
  std::set<std::uint64_t> codes;
  for (const Json& r : v.at("spare")) codes.insert({r[0].get<std::uint64_t>(), r[1].get<std::uint64_t>()});
  // Of a subscriber number the digits A to E are "not used", which is no spare value (7.5.1.95);
  // that a train refuses them is in faults_groups.scenario.
  if (v.at("kind") == "bcd" && v.at("name") != "NID_RADIO") codes.insert(all_ones(v.at("bits")) - 5);  // ...FFFA
  return {codes.begin(), codes.end()};
}

void BitList::put(std::uint64_t code, unsigned bits) {
  for (unsigned i = bits; i-- > 0;) bits_.push_back(((code >> i) & 1u) != 0);
}
void BitList::replace(std::size_t at, std::uint64_t code, unsigned bits) {
  for (unsigned i = 0; i < bits; ++i) bits_[at + i] = ((code >> (bits - 1 - i)) & 1u) != 0;
}
std::vector<std::uint8_t> BitList::bytes() const {
  std::vector<std::uint8_t> out((bits_.size() + 7) / 8, 0);
  for (std::size_t i = 0; i < bits_.size(); ++i)
    if (bits_[i]) out[i / 8] = static_cast<std::uint8_t>(out[i / 8] | 0x80u >> (i % 8));
  return out;
}
void append(BitList& to, const BitList& what) {
  const std::vector<std::uint8_t> bytes = what.bytes();
  for (std::size_t i = 0; i < what.size(); ++i) to.put((bytes[i / 8] >> (7 - i % 8)) & 1u, 1);
}

std::vector<Field> fields_of(const Json& elements) {
  std::vector<Field> fields;
  collect(fields, elements, "", {});
  return fields;
}

const Json* find_packet(const std::string& direction, unsigned id, const std::string& sv) {
  return find(direction == "to_train" ? "packets_to_train" : "packets_to_track", "packets", id, sv);
}
const Json* find_message(const std::string& direction, unsigned id, const std::string& sv) {
  return find(direction == "to_train" ? "messages_to_train" : "messages_to_track", "messages", id, sv);
}

std::uint64_t usual(const std::string& key, const std::string& name) {
  static const Codes codes{{"Q_DIR", 1},
                           {"Q_SCALE", 1},
                           {"Q_GDIR", 1},
                           {"M_VERSION", 33},
                           {"T_EMA", 1023},
                           {"V_MAIN", 32},
                           {"Q_LINKORIENTATION", 1},
                           {"Q_LINKREACTION", 2},
                           {"NID_C", 1},
                           {"NID_RBC", 1},
                           {"NID_LRBG", 1 << 14 | 100},
                           {"M_MODETEXTDISPLAY", 15},
                           {"M_MODETEXTDISPLAY_V1", 15},
                           {"M_LEVELTEXTDISPLAY", 5},
                           {"T_TEXTDISPLAY", 1023},
                           {"L_TEXTDISPLAY", 32767},
                           {"M_LINEGAUGE", 1},
                           {"NID_RADIO", ~std::uint64_t{0}},
                           {"NID_MN", 0x123FFF},
                           {"NID_OPERATIONAL", 0x4711FFFF},
                           {"NID_OPERATIONAL_V1", 0x4711FFFF},
                           {"D_VALIDNV", 32767},
                           {"V_STATIC", 28},
                           {"V_TSR", 16},
                           {"V_AXLELOAD", 16},
                           {"L_TSR", 500},
                           {"L_AXLELOAD", 500},
                           {"L_ENDSECTION", 3000},
                           {"L_SECTION", 500}};
  const auto named = codes.find(name);
  if (named != codes.end()) return named->second;
  const auto known = codes.find(key);
  return known != codes.end() ? known->second : 0;
}

std::uint64_t in_scale(std::uint64_t metres, std::uint64_t Q_SCALE) {
  return Q_SCALE == 0 ? 10 * metres : Q_SCALE == 1 ? metres : metres / 10;
}

void put_packet(BitList& to, const Json& packet, const Codes& codes, int wrong_length) {
  const std::vector<Field> fields = fields_of(packet.at("elements"));
  for (const auto& [path, code] : codes)
    if (!is_known(fields, path)) throw std::runtime_error(packet.at("id").dump() + " has no " + path);
  const std::size_t from = to.size();
  Codes all = codes;
  all["NID_PACKET"] = packet.at("id").get<std::uint64_t>();
  Writer writer(to, all);
  writer.put(packet.at("elements"));
  if (writer.length_at != 0)
    to.replace(writer.length_at, static_cast<std::uint64_t>(static_cast<int>(to.size() - from) + wrong_length), 13);
}

BitList message_bits(const Json& message, const Codes& codes, const BitList& packets) {
  BitList bits;
  Codes all = codes;
  all["NID_MESSAGE"] = message.at("id").get<std::uint64_t>();
  Writer writer(bits, all);
  writer.put(message.at("elements"));
  append(bits, packets);
  while (bits.size() % 8 != 0) bits.put(0, 1);
  bits.replace(writer.length_at, bits.size() / 8, 10);
  return bits;
}

const Codes* Decoded::packet(unsigned id) const {
  for (const auto& [number, of_packet] : packets)
    if (number == id) return &of_packet;
  return nullptr;
}

Decoded decode_to_track(const std::vector<std::uint8_t>& bytes, const std::string& sv) {
  Decoded d;
  Reader reader(bytes, 0);
  const Json* message = bytes.empty() ? nullptr : find_message("to_track", bytes[0], sv);
  if (message == nullptr) return d;
  reader.read(message->at("elements"), "", d.codes);
  while (reader.at() + 16 < 8 * bytes.size()) {
    Reader ahead(bytes, reader.at());
    const auto id = static_cast<unsigned>(ahead.get(8));
    const auto length = ahead.get(13);
    const Json* packet = find_packet("to_track", id, sv);
    if (packet == nullptr || length == 0) return d;
    Codes codes;
    const std::size_t from = reader.at();
    reader.read(packet->at("elements"), "", codes);
    if (reader.at() - from != length) return d;
    d.packets.emplace_back(id, codes);
  }
  d.complete = d.codes.at("L_MESSAGE") == bytes.size() && 8 * bytes.size() - reader.at() < 8;
  return d;
}

}  // namespace evc::through_step
