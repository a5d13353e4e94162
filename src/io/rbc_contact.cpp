#include "io/rbc_contact.h"

namespace evc::io {

std::uint64_t read_NID_RADIO(const JsonPlace& place) {
  if (place.string().size() != 16) place.fail("16 hexadecimal digits");
  std::uint64_t NID_RADIO = 0;
  for (const std::uint8_t byte : place.hex()) NID_RADIO = NID_RADIO << 8 | byte;
  return NID_RADIO;
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
