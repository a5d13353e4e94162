#pragma once
#include "track/store.h"

// The parts of `store`, one file each.
namespace evc::track {

/// One message while it is stored.
struct Filing {
  Description& d;
  const Here& here;
  Stored& report;

  void note(std::uint8_t packet, Note::What what, Clause clause) const {
    // The report has room for one note per kind of packet; when it is full, notes are lost, never
    // data.
    if (!report.notes.full()) (void)report.notes.push_back({packet, what, clause});
  }
  void stored(std::uint8_t packet, bool room, Clause clause) const {
    if (room)
      note(packet, Note::What::stored, {});
    else
      note(packet, Note::What::full, clause);
  }
  /// Data of `packet` that restrict from `from` on did not fit.
  void lost(std::uint8_t packet, Place from, Clause clause) const {
    note(packet, Note::What::full, clause);
    if (!report.lost_from || from < *report.lost_from) report.lost_from = from;
  }
};

/// The MA with its mode profile and list for SH: shortening, timers (3.8). `infill`: see Contents. `described`: SSP and
/// gradient cover it (3.7.2.3).
void store_authority(const Filing& filing, const AuthorityContents& c, const std::optional<Place>& infill,
                     bool described, Clause refuse_ma);
/// V_MAIN (3.11.6).
void store_signalling_speed(const Filing& filing, const Contents& c);
/// Packet 16 (3.8.5.2).
void reposition(const Filing& filing, const Contents& c);

}  // namespace evc::track
