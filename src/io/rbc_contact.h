#pragma once
#include <cstdint>

#include "io/json.h"
#include "port/inputs.h"
#include "port/outputs.h"

namespace evc::io {

/// NID_RADIO (7.5.1.95) as 16 hexadecimal digits. Throws ReadError.
std::uint64_t read_NID_RADIO(const JsonPlace& place);

/// The members NID_C, NID_RBC and NID_RADIO of an object: a contact that the driver enters. Throws ReadError.
port::DriverActions::RbcContact read_rbc_contact(const JsonPlace& place);
/// The same where the object has no other members.
port::RbcAddress read_address(const JsonPlace& place);

}  // namespace evc::io
