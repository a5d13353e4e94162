#include "io/rbc_contact.h"

namespace evc::io {

std::uint64_t read_NID_RADIO(const JsonPlace& place) {
  if (place.string().size() != 16) place.fail("16 hexadecimal digits");
  std::uint64_t NID_RADIO = 0;
  for (const std::uint8_t byte : place.hex()) NID_RADIO = NID_RADIO << 8 | byte;
  return NID_RADIO;
}

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
  for (unsigned shift = 24; shift != 0;) {
    shift -= 4;
    const std::uint32_t digit = NID_MN >> shift & 15u;
    if (digit < 10) digits += static_cast<char>('0' + digit);
  }
  return digits;
}

port::DriverActions::RbcContact read_rbc_contact(const JsonPlace& place) {
  return {static_cast<std::uint16_t>(place["NID_C"].integer(0, 1023)),
          static_cast<std::uint16_t>(place["NID_RBC"].integer(0, 16383)), read_NID_RADIO(place["NID_RADIO"])};
}

port::RbcAddress read_address(const JsonPlace& place) {
  place.know_only({"NID_C", "NID_RBC", "NID_RADIO"});
  const port::DriverActions::RbcContact contact = read_rbc_contact(place);
  return {contact.NID_C, contact.NID_RBC, contact.NID_RADIO};
}

}  // namespace evc::io
