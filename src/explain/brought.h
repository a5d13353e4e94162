#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "track/description.h"

// Which packet brought each element of the track description that is stored.
namespace evc::explain {

/// The number of a note of the journal.
using NoteIndex = std::size_t;

// Whether two elements are the same one. Its places move only with the unlinked group on which they hang (3.6.4.7).
bool alike(const track::StaticSpeedProfile::Step& a, const track::StaticSpeedProfile::Step& b);
bool alike(const track::AxleLoadRestriction& a, const track::AxleLoadRestriction& b);
bool alike(const track::TemporarySpeedRestriction& a, const track::TemporarySpeedRestriction& b);
bool alike(const track::PermittedBrakingDistance& a, const track::PermittedBrakingDistance& b);
bool alike(const track::LevelCrossing& a, const track::LevelCrossing& b);
bool alike(const track::ModeArea& a, const track::ModeArea& b);
bool alike(const track::RouteSuitability& a, const track::RouteSuitability& b);
bool alike(const track::AdhesionArea& a, const track::AdhesionArea& b);
bool alike(const track::TrackCondition& a, const track::TrackCondition& b);

/// The elements of one kind, each with the packet that brought it first. An element that a later packet repeats stays
/// of the first one; one that says something else under the same identity is new.
template <class T>
class BroughtList {
 public:
  /// After a cycle: `now` is stored; what was not known came with `packet`. Absent: none of this kind was accepted yet.
  template <class List>
  void take(const List& now, std::optional<NoteIndex> packet) {
    std::vector<Known> fresh;
    for (const T& element : now) {
      if (const auto note = of(element))
        fresh.push_back({element, *note});
      else if (packet)
        fresh.push_back({element, *packet});
    }
    known_ = std::move(fresh);
  }
  std::optional<NoteIndex> of(const T& element) const {
    for (const Known& known : known_)
      if (alike(known.element, element)) return known.note;
    return std::nullopt;
  }

 private:
  struct Known {
    T element;
    NoteIndex note = 0;
  };
  std::vector<Known> known_;
};

/// Those of the whole description.
struct Brought {
  BroughtList<track::StaticSpeedProfile::Step> ssp;
  BroughtList<track::AxleLoadRestriction> asp;
  BroughtList<track::TemporarySpeedRestriction> tsr;
  BroughtList<track::PermittedBrakingDistance> pbd;
  BroughtList<track::LevelCrossing> lx;
  BroughtList<track::ModeArea> areas;
  BroughtList<track::RouteSuitability> suitability;
  BroughtList<track::AdhesionArea> adhesion;
  BroughtList<track::TrackCondition> conditions;
};

}  // namespace evc::explain
