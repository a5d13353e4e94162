#pragma once
#include <cstdint>
#include <string>

#include "io/json.h"
#include "port/inputs.h"
#include "port/outputs.h"

namespace evc::io {

/// NID_RADIO (7.5.1.95): 16 digits, decimal ones filled up with F, or F alone: the stored number. Throws ReadError.
std::uint64_t read_NID_RADIO(const JsonPlace& place);

/// NID_MN (7.5.1.91.1) from 1 to 6 decimal digits: BCD, left adjusted, filled with F. Throws ReadError.
std::uint32_t read_NID_MN(const JsonPlace& place);
/// Its digits.
std::string digits_of_NID_MN(std::uint32_t NID_MN);

/// The members NID_C, NID_RBC and NID_RADIO of an object: a contact that the driver enters. Throws ReadError.
port::DriverActions::RbcContact read_rbc_contact(const JsonPlace& place);
/// The same where the object has no other members.
port::RbcAddress read_address(const JsonPlace& place);
/// The same of what a unit kept: its number may be one of trackside, with any digits.
port::RbcAddress read_kept_address(const JsonPlace& place);

/// NID_RADIO as it is read, without quotes.
void append_NID_RADIO(std::string& out, std::uint64_t NID_RADIO);
/// `,"NID_RBC":` or `,"NID_RIU":`.
const char* number_key(bool infill_unit);
/// The object with the three members.
void append_contact(std::string& out, std::uint16_t NID_C, std::uint16_t NID_RBC, std::uint64_t NID_RADIO,
                    bool infill_unit = false);

}  // namespace evc::io
