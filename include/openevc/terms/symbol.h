#pragma once
#include "openevc/terms/row.h"

namespace evc {

// clang-format off
/// The symbols that the driver machine interface shows, with their names of ERA_ERTMS_015560.
enum class Symbol : std::uint8_t {
  // Levels; then announced levels, alternating without and with acknowledgement.
  LE01, LE02, LE03, LE04, LE05,
  LE06, LE07, LE08, LE09, LE10, LE11, LE12, LE13, LE14, LE15,
  // Modes and the acknowledgement of modes; MO03 is override.
  MO01, MO02, MO03, MO04, MO05, MO06, MO07, MO08, MO09, MO10, MO11,
  MO12, MO13, MO14, MO15, MO16, MO17, MO18, MO19, MO20, MO21, MO22, MO23, MO24,
  ST01,  ///< service or emergency brake intervention
  ST02,  ///< slippery rail
  ST03,  ///< safe radio connection up
  ST04,  ///< safe radio connection lost, or it could not be set up
  ST06,  ///< reversing permitted
  LS01,  ///< lowest supervised speed within the MA
  LX01,  ///< level crossing not protected
  DR02,  ///< track ahead free asked for
  // Track conditions; where an action is due, the symbol that asks the driver for it (for the train: below).
  TC01, TC03, TC05,  ///< pantograph: lowered, to be lowered, to be raised
  TC06, TC07, TC09,  ///< neutral section: inside, announced, its end
  TC10, TC11,        ///< non stopping area: inside, announced
  TC12,              ///< radio hole
  TC13, TC14,        ///< magnetic shoe brake: inhibited, announced
  TC15, TC16,        ///< eddy current brake: inhibited, announced
  TC17, TC18,        ///< regenerative brake: inhibited, announced
  TC19, TC21, TC22,  ///< air conditioning intake: closed, to be closed, to be opened
  // Change of traction system, alternating the new one and its announcement: none, AC 25 kV, AC 15 kV, DC 3 kV, DC 1.5
  // kV, DC 600/750 V.
  TC23, TC24, TC25, TC26, TC27, TC28, TC29, TC30, TC31, TC32, TC33, TC34,
  TC35,        ///< sound horn
  TC36, TC37,  ///< tunnel stopping area: inside, announced
  // The advance display (3.15.10); where an action is due, the symbol that asks the driver for it (for the train: below).
  PL02, PL04,  ///< pantograph: to be lowered, to be raised
  PL06, PL08,  ///< neutral section: begins, ends
  PL09, PL10,  ///< non stopping area, radio hole
  PL12, PL14,  ///< magnetic shoe brake, eddy current brake: inhibited
  PL16,        ///< regenerative brake: inhibited
  PL19, PL20,  ///< air conditioning intake: to be closed, to be opened
  PL24,        ///< sound horn
  // Change of traction system, as above.
  PL26, PL28, PL30, PL32, PL34, PL36,
  // Where the train acts by itself; of the other announcements the symbol is that of being inside.
  TC02, TC04,  ///< pantograph: to be lowered, to be raised
  TC08,        ///< neutral section: its end
  TC20,        ///< air conditioning intake: to be opened
  PL01, PL03,  ///< pantograph: to be lowered, to be raised
  PL05, PL07,  ///< neutral section: begins, ends
  PL11, PL13,  ///< magnetic shoe brake, eddy current brake: inhibited
  PL15,        ///< regenerative brake: inhibited
  PL17, PL18,  ///< air conditioning intake: to be closed, to be opened
  // Change of traction system, as above.
  PL25, PL27, PL29, PL31, PL33, PL35,
  count
};

inline constexpr auto kSymbolRows = std::to_array<terms::Row<Symbol>>({
    {Symbol::LE01, "LE01"}, {Symbol::LE02, "LE02"}, {Symbol::LE03, "LE03"}, {Symbol::LE04, "LE04"}, {Symbol::LE05, "LE05"},
    {Symbol::LE06, "LE06"}, {Symbol::LE07, "LE07"}, {Symbol::LE08, "LE08"}, {Symbol::LE09, "LE09"}, {Symbol::LE10, "LE10"},
    {Symbol::LE11, "LE11"}, {Symbol::LE12, "LE12"}, {Symbol::LE13, "LE13"}, {Symbol::LE14, "LE14"}, {Symbol::LE15, "LE15"},
    {Symbol::MO01, "MO01"}, {Symbol::MO02, "MO02"}, {Symbol::MO03, "MO03"}, {Symbol::MO04, "MO04"}, {Symbol::MO05, "MO05"},
    {Symbol::MO06, "MO06"}, {Symbol::MO07, "MO07"}, {Symbol::MO08, "MO08"}, {Symbol::MO09, "MO09"}, {Symbol::MO10, "MO10"},
    {Symbol::MO11, "MO11"}, {Symbol::MO12, "MO12"}, {Symbol::MO13, "MO13"}, {Symbol::MO14, "MO14"}, {Symbol::MO15, "MO15"},
    {Symbol::MO16, "MO16"}, {Symbol::MO17, "MO17"}, {Symbol::MO18, "MO18"}, {Symbol::MO19, "MO19"}, {Symbol::MO20, "MO20"},
    {Symbol::MO21, "MO21"}, {Symbol::MO22, "MO22"}, {Symbol::MO23, "MO23"}, {Symbol::MO24, "MO24"}, {Symbol::ST01, "ST01"}, {Symbol::ST02, "ST02"}, {Symbol::ST03, "ST03"},
    {Symbol::ST04, "ST04"}, {Symbol::ST06, "ST06"}, {Symbol::LS01, "LS01"}, {Symbol::LX01, "LX01"}, {Symbol::DR02, "DR02"},
    {Symbol::TC01, "TC01"}, {Symbol::TC03, "TC03"}, {Symbol::TC05, "TC05"}, {Symbol::TC06, "TC06"}, {Symbol::TC07, "TC07"},
    {Symbol::TC09, "TC09"}, {Symbol::TC10, "TC10"}, {Symbol::TC11, "TC11"}, {Symbol::TC12, "TC12"}, {Symbol::TC13, "TC13"},
    {Symbol::TC14, "TC14"}, {Symbol::TC15, "TC15"}, {Symbol::TC16, "TC16"}, {Symbol::TC17, "TC17"}, {Symbol::TC18, "TC18"},
    {Symbol::TC19, "TC19"}, {Symbol::TC21, "TC21"}, {Symbol::TC22, "TC22"}, {Symbol::TC23, "TC23"}, {Symbol::TC24, "TC24"},
    {Symbol::TC25, "TC25"}, {Symbol::TC26, "TC26"}, {Symbol::TC27, "TC27"}, {Symbol::TC28, "TC28"}, {Symbol::TC29, "TC29"},
    {Symbol::TC30, "TC30"}, {Symbol::TC31, "TC31"}, {Symbol::TC32, "TC32"}, {Symbol::TC33, "TC33"}, {Symbol::TC34, "TC34"},
    {Symbol::TC35, "TC35"}, {Symbol::TC36, "TC36"}, {Symbol::TC37, "TC37"}, {Symbol::PL02, "PL02"}, {Symbol::PL04, "PL04"},
    {Symbol::PL06, "PL06"}, {Symbol::PL08, "PL08"}, {Symbol::PL09, "PL09"}, {Symbol::PL10, "PL10"}, {Symbol::PL12, "PL12"},
    {Symbol::PL14, "PL14"}, {Symbol::PL16, "PL16"}, {Symbol::PL19, "PL19"}, {Symbol::PL20, "PL20"}, {Symbol::PL24, "PL24"},
    {Symbol::PL26, "PL26"}, {Symbol::PL28, "PL28"}, {Symbol::PL30, "PL30"}, {Symbol::PL32, "PL32"}, {Symbol::PL34, "PL34"},
    {Symbol::PL36, "PL36"}, {Symbol::TC02, "TC02"}, {Symbol::TC04, "TC04"}, {Symbol::TC08, "TC08"}, {Symbol::TC20, "TC20"},
    {Symbol::PL01, "PL01"}, {Symbol::PL03, "PL03"}, {Symbol::PL05, "PL05"}, {Symbol::PL07, "PL07"}, {Symbol::PL11, "PL11"},
    {Symbol::PL13, "PL13"}, {Symbol::PL15, "PL15"}, {Symbol::PL17, "PL17"}, {Symbol::PL18, "PL18"}, {Symbol::PL25, "PL25"},
    {Symbol::PL27, "PL27"}, {Symbol::PL29, "PL29"}, {Symbol::PL31, "PL31"}, {Symbol::PL33, "PL33"}, {Symbol::PL35, "PL35"},
});
// clang-format on
static_assert(terms::in_order(kSymbolRows) && kSymbolRows.size() == terms::index(Symbol::count));

/// "MO07".
constexpr const char* name(Symbol symbol) { return terms::kNames<kSymbolRows>[terms::index(symbol)]; }

}  // namespace evc
