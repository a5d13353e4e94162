#pragma once
#include "base/inplace_vector.h"
#include "terms/information.h"

namespace evc::modes {

/// The rows that one packet or message fills.
using Informations = InplaceVector<Information, 2>;

/// The rows of packet NID_PACKET of the direction track to train. `detail` is M_TRACKCOND for packet 68 and Q_LSSMA
/// for packet 180, otherwise not used. Empty where the packet is no row of its own: 49, 63 and 80 belong to the MA,
/// SR or SH authorisation that they come with; 0, 145 and 255 act before the tables (4.8.2.2); or it is not known.
Informations information_of_packet(int NID_PACKET, int detail = 0);

/// The rows of radio message NID_MESSAGE itself, without its packets. Empty for 24 (packets only), 37 (infill) and
/// those that are not known; 3 and 33 are the movement authority.
Informations information_of_message(int NID_MESSAGE);

}  // namespace evc::modes
