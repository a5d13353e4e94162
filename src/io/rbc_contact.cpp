#include "io/rbc_contact.h"

#include <algorithm>

#include "io/number.h"

namespace evc::io {
namespace {

constexpr const char* kDigits = "16 digits: decimal ones, filled up with F";

/// `of_trackside`: as it was sent, with F, which is no digit, in any place (7.5.1.95).
std::uint64_t read_digits(const JsonPlace& place, bool of_trackside) {
  const std::string& text = place.string();
  const std::size_t filled = std::min(text.find_first_not_of("0123456789"), text.size());
  const char* const rest = of_trackside ? "0123456789Ff" : "Ff";
  if (text.size() != 16 || text.find_first_not_of(rest, filled) != std::string::npos) place.fail(kDigits);
  std::uint64_t NID_RADIO = 0;
  for (const std::uint8_t byte : place.hex()) NID_RADIO = NID_RADIO << 8 | byte;
  return NID_RADIO;
}

port::RbcAddress address(const JsonPlace& place, bool of_trackside) {
  place.know_only({"NID_C", "NID_RBC", "NID_RADIO"});
  return {static_cast<std::uint16_t>(place["NID_C"].integer(0, 1023)),
          static_cast<std::uint16_t>(place["NID_RBC"].integer(0, 16383)),
          read_digits(place["NID_RADIO"], of_trackside)};
}

}  // namespace

std::uint64_t read_NID_RADIO(const JsonPlace& place) { return read_digits(place, false); }

std::uint32_t read_NID_MN(const JsonPlace& place) {
  const std::string& digits = place.string();
  if (digits.empty() || digits.size() > 6 || digits.find_first_not_of("0123456789") != std::string::npos)
    place.fail("1 to 6 decimal digits");
  std::uint32_t NID_MN = 0;
  for (std::size_t i = 0; i < 6; ++i)
    NID_MN = NID_MN << 4 | (i < digits.size() ? static_cast<std::uint32_t>(digits[i] - '0') : 15u);
  return NID_MN;
}

std::string digits_of_NID_MN(std::uint32_t NID_MN) {
  std::string digits;
  append_packed(digits, NID_MN << 8 | 0xFFu);
  return digits;
}

port::DriverActions::RbcContact read_rbc_contact(const JsonPlace& place) {
  return {static_cast<std::uint16_t>(place["NID_C"].integer(0, 1023)),
          static_cast<std::uint16_t>(place["NID_RBC"].integer(0, 16383)), read_NID_RADIO(place["NID_RADIO"])};
}

port::RbcAddress read_address(const JsonPlace& place) { return address(place, false); }
port::RbcAddress read_kept_address(const JsonPlace& place) { return address(place, true); }

const char* number_key(bool infill_unit) { return infill_unit ? ",\"NID_RIU\":" : ",\"NID_RBC\":"; }

void append_NID_RADIO(std::string& out, std::uint64_t NID_RADIO) {
  std::uint8_t bytes[8];
  for (unsigned i = 0; i < 8; ++i) bytes[i] = static_cast<std::uint8_t>((NID_RADIO >> (56 - 8 * i)) & 0xffu);
  append_hex(out, bytes);
}

void append_contact(std::string& out, std::uint16_t NID_C, std::uint16_t NID_RBC, std::uint64_t NID_RADIO,
                    bool infill_unit) {
  out += "{\"NID_C\":";
  append_number(out, std::int64_t{NID_C});
  out += number_key(infill_unit);
  append_number(out, std::int64_t{NID_RBC});
  out += ",\"NID_RADIO\":\"";
  append_NID_RADIO(out, NID_RADIO);
  out += "\"}";
}

}  // namespace evc::io
