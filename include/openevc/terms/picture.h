#pragma once
#include <optional>

#include "openevc/terms/row.h"
#include "openevc/terms/symbol.h"

namespace evc {

// clang-format off
/// All symbols of ERA_ERTMS_015560 13 with their names there; those of level 3 (LE05, LE11, LE13 to LE15) are of 3.6.0. Of them
/// Symbol names those that the on-board itself speaks of.
enum class Picture : std::uint8_t {
  LE01, LE02, LE03, LE04, LE05, LE06, LE07, LE08, LE09, LE10, LE11, LE12, LE13, LE14, LE15,
  MO01, MO02, MO03, MO04, MO05, MO06, MO07, MO08, MO09, MO10, MO11, MO12, MO13, MO14, MO15, MO16, MO17, MO18, MO19,
  MO20, MO21, MO22, MO23, MO24,
  ST01, ST02, ST03, ST04, ST05, ST06, ST07,
  TC01, TC02, TC03, TC04, TC05, TC06, TC07, TC08, TC09, TC10, TC11, TC12, TC13, TC14, TC15, TC16, TC17, TC18, TC19,
  TC20, TC21, TC22, TC23, TC24, TC25, TC26, TC27, TC28, TC29, TC30, TC31, TC32, TC33, TC34, TC35, TC36, TC37,
  PL01, PL02, PL03, PL04, PL05, PL06, PL07, PL08, PL09, PL10, PL11, PL12, PL13, PL14, PL15, PL16, PL17, PL18, PL19,
  PL20, PL21, PL22, PL23, PL24, PL25, PL26, PL27, PL28, PL29, PL30, PL31, PL32, PL33, PL34, PL35, PL36, PL37,
  NA03, NA04, NA05, NA06, NA07, NA08, NA09, NA10, NA11, NA12, NA13, NA14, NA15, NA16, NA17, NA18, NA18_2, NA19,
  NA20, NA21, NA22, NA23,
  SE01, SE02, SE03, SE04,
  DR01, DR02, DR03, DR04, DR05,
  LX01,
  LS01,
  SM01, SM02,
  ATO01, ATO02, ATO03, ATO04, ATO05, ATO06, ATO07, ATO08, ATO09, ATO10, ATO11, ATO12, ATO13, ATO14, ATO15, ATO16,
  ATO17, ATO18, ATO19, ATO20, ATO21,
  count
};

/// A symbol with its width and height in cells.
struct PictureRow {
  Picture value;
  const char* name;
  std::uint8_t width, height;
};

inline constexpr auto kPictureRows = std::to_array<PictureRow>({
    {Picture::LE01, "LE01", 52, 21}, {Picture::LE02, "LE02", 52, 21}, {Picture::LE03, "LE03", 52, 21},
    {Picture::LE04, "LE04", 52, 21}, {Picture::LE05, "LE05", 52, 21}, {Picture::LE06, "LE06", 52, 21},
    {Picture::LE07, "LE07", 52, 21}, {Picture::LE08, "LE08", 52, 21}, {Picture::LE09, "LE09", 52, 21},
    {Picture::LE10, "LE10", 52, 21}, {Picture::LE11, "LE11", 52, 21}, {Picture::LE12, "LE12", 52, 21},
    {Picture::LE13, "LE13", 52, 21}, {Picture::LE14, "LE14", 52, 21}, {Picture::LE15, "LE15", 52, 21},
    {Picture::MO01, "MO01", 32, 32}, {Picture::MO02, "MO02", 32, 32}, {Picture::MO03, "MO03", 32, 32},
    {Picture::MO04, "MO04", 32, 32}, {Picture::MO05, "MO05", 32, 32}, {Picture::MO06, "MO06", 32, 32},
    {Picture::MO07, "MO07", 32, 32}, {Picture::MO08, "MO08", 32, 32}, {Picture::MO09, "MO09", 32, 32},
    {Picture::MO10, "MO10", 46, 46}, {Picture::MO11, "MO11", 32, 32}, {Picture::MO12, "MO12", 32, 32},
    {Picture::MO13, "MO13", 32, 32}, {Picture::MO14, "MO14", 32, 32}, {Picture::MO15, "MO15", 32, 32},
    {Picture::MO16, "MO16", 32, 32}, {Picture::MO17, "MO17", 32, 32}, {Picture::MO18, "MO18", 32, 32},
    {Picture::MO19, "MO19", 32, 32}, {Picture::MO20, "MO20", 32, 32}, {Picture::MO21, "MO21", 32, 32},
    {Picture::MO22, "MO22", 32, 32}, {Picture::MO23, "MO23", 32, 32}, {Picture::MO24, "MO24", 32, 32},
    {Picture::ST01, "ST01", 52, 21}, {Picture::ST02, "ST02", 52, 21}, {Picture::ST03, "ST03", 52, 21},
    {Picture::ST04, "ST04", 52, 21}, {Picture::ST05, "ST05", 20, 20}, {Picture::ST06, "ST06", 32, 32},
    {Picture::ST07, "ST07", 32, 32}, {Picture::TC01, "TC01", 32, 32}, {Picture::TC02, "TC02", 32, 32},
    {Picture::TC03, "TC03", 32, 32}, {Picture::TC04, "TC04", 32, 32}, {Picture::TC05, "TC05", 32, 32},
    {Picture::TC06, "TC06", 32, 32}, {Picture::TC07, "TC07", 32, 32}, {Picture::TC08, "TC08", 32, 32},
    {Picture::TC09, "TC09", 32, 32}, {Picture::TC10, "TC10", 32, 32}, {Picture::TC11, "TC11", 32, 32},
    {Picture::TC12, "TC12", 32, 32}, {Picture::TC13, "TC13", 32, 32}, {Picture::TC14, "TC14", 32, 32},
    {Picture::TC15, "TC15", 32, 32}, {Picture::TC16, "TC16", 32, 32}, {Picture::TC17, "TC17", 32, 32},
    {Picture::TC18, "TC18", 32, 32}, {Picture::TC19, "TC19", 32, 32}, {Picture::TC20, "TC20", 32, 32},
    {Picture::TC21, "TC21", 32, 32}, {Picture::TC22, "TC22", 32, 32}, {Picture::TC23, "TC23", 32, 32},
    {Picture::TC24, "TC24", 32, 32}, {Picture::TC25, "TC25", 32, 32}, {Picture::TC26, "TC26", 32, 32},
    {Picture::TC27, "TC27", 32, 32}, {Picture::TC28, "TC28", 32, 32}, {Picture::TC29, "TC29", 32, 32},
    {Picture::TC30, "TC30", 32, 32}, {Picture::TC31, "TC31", 32, 32}, {Picture::TC32, "TC32", 32, 32},
    {Picture::TC33, "TC33", 32, 32}, {Picture::TC34, "TC34", 32, 32}, {Picture::TC35, "TC35", 32, 32},
    {Picture::TC36, "TC36", 32, 32}, {Picture::TC37, "TC37", 32, 32}, {Picture::PL01, "PL01", 20, 20},
    {Picture::PL02, "PL02", 20, 20}, {Picture::PL03, "PL03", 20, 20}, {Picture::PL04, "PL04", 20, 20},
    {Picture::PL05, "PL05", 20, 20}, {Picture::PL06, "PL06", 20, 20}, {Picture::PL07, "PL07", 20, 20},
    {Picture::PL08, "PL08", 20, 20}, {Picture::PL09, "PL09", 20, 20}, {Picture::PL10, "PL10", 20, 20},
    {Picture::PL11, "PL11", 20, 20}, {Picture::PL12, "PL12", 20, 20}, {Picture::PL13, "PL13", 20, 20},
    {Picture::PL14, "PL14", 20, 20}, {Picture::PL15, "PL15", 20, 20}, {Picture::PL16, "PL16", 20, 20},
    {Picture::PL17, "PL17", 20, 20}, {Picture::PL18, "PL18", 20, 20}, {Picture::PL19, "PL19", 20, 20},
    {Picture::PL20, "PL20", 20, 20}, {Picture::PL21, "PL21", 20, 20}, {Picture::PL22, "PL22", 20, 20},
    {Picture::PL23, "PL23", 20, 20}, {Picture::PL24, "PL24", 20, 20}, {Picture::PL25, "PL25", 20, 20},
    {Picture::PL26, "PL26", 20, 20}, {Picture::PL27, "PL27", 20, 20}, {Picture::PL28, "PL28", 20, 20},
    {Picture::PL29, "PL29", 20, 20}, {Picture::PL30, "PL30", 20, 20}, {Picture::PL31, "PL31", 20, 20},
    {Picture::PL32, "PL32", 20, 20}, {Picture::PL33, "PL33", 20, 20}, {Picture::PL34, "PL34", 20, 20},
    {Picture::PL35, "PL35", 20, 20}, {Picture::PL36, "PL36", 20, 20}, {Picture::PL37, "PL37", 20, 20},
    {Picture::NA03, "NA03", 12, 12}, {Picture::NA04, "NA04", 12, 12}, {Picture::NA05, "NA05", 12, 12},
    {Picture::NA06, "NA06", 12, 12}, {Picture::NA07, "NA07", 32, 32}, {Picture::NA08, "NA08", 32, 32},
    {Picture::NA09, "NA09", 32, 32}, {Picture::NA10, "NA10", 32, 32}, {Picture::NA11, "NA11", 32, 32},
    {Picture::NA12, "NA12", 32, 32}, {Picture::NA13, "NA13", 32, 32}, {Picture::NA14, "NA14", 32, 32},
    {Picture::NA15, "NA15", 32, 32}, {Picture::NA16, "NA16", 32, 32}, {Picture::NA17, "NA17", 32, 32},
    {Picture::NA18, "NA18", 32, 32}, {Picture::NA18_2, "NA18.2", 32, 32}, {Picture::NA19, "NA19", 32, 32},
    {Picture::NA20, "NA20", 32, 32}, {Picture::NA21, "NA21", 32, 32}, {Picture::NA22, "NA22", 32, 32},
    {Picture::NA23, "NA23", 32, 32}, {Picture::SE01, "SE01", 32, 32}, {Picture::SE02, "SE02", 32, 32},
    {Picture::SE03, "SE03", 32, 32}, {Picture::SE04, "SE04", 32, 32}, {Picture::DR01, "DR01", 32, 32},
    {Picture::DR02, "DR02", 75, 46}, {Picture::DR03, "DR03", 32, 32}, {Picture::DR04, "DR04", 32, 32},
    {Picture::DR05, "DR05", 32, 32}, {Picture::LX01, "LX01", 32, 32}, {Picture::LS01, "LS01", 50, 50},
    {Picture::SM01, "SM01", 32, 32}, {Picture::SM02, "SM02", 32, 32}, {Picture::ATO01, "ATO01", 45, 45},
    {Picture::ATO02, "ATO02", 45, 45}, {Picture::ATO03, "ATO03", 45, 45}, {Picture::ATO04, "ATO04", 45, 45},
    {Picture::ATO05, "ATO05", 45, 45}, {Picture::ATO06, "ATO06", 45, 45}, {Picture::ATO07, "ATO07", 45, 45},
    {Picture::ATO08, "ATO08", 45, 45}, {Picture::ATO09, "ATO09", 45, 45}, {Picture::ATO10, "ATO10", 45, 45},
    {Picture::ATO11, "ATO11", 45, 45}, {Picture::ATO12, "ATO12", 45, 45}, {Picture::ATO13, "ATO13", 45, 45},
    {Picture::ATO14, "ATO14", 45, 45}, {Picture::ATO15, "ATO15", 45, 45}, {Picture::ATO16, "ATO16", 45, 45},
    {Picture::ATO17, "ATO17", 45, 45}, {Picture::ATO18, "ATO18", 45, 45}, {Picture::ATO19, "ATO19", 45, 45},
    {Picture::ATO20, "ATO20", 32, 32}, {Picture::ATO21, "ATO21", 20, 20},
});
// clang-format on
static_assert(terms::in_order(kPictureRows) && kPictureRows.size() == terms::index(Picture::count));

/// "MO07", "NA18.2".
constexpr const char* name(Picture picture) { return terms::kNames<kPictureRows>[terms::index(picture)]; }

/// The pictures of the on-board's symbols, by their names.
inline constexpr auto kPictureOfSymbol = [] {
  std::array<Picture, kSymbolRows.size()> pictures{};
  for (std::size_t s = 0; s < pictures.size(); ++s) {
    pictures[s] = Picture::count;
    for (const PictureRow& row : kPictureRows) {
      const char *a = row.name, *b = kSymbolRows[s].name;
      while (*a != '\0' && *a == *b) ++a, ++b;
      if (*a == *b) pictures[s] = row.value;
    }
  }
  return pictures;
}();
static_assert([] {
  for (const Picture picture : kPictureOfSymbol)
    if (picture == Picture::count) return false;
  return true;
}());

constexpr Picture picture_of(Symbol symbol) { return kPictureOfSymbol[terms::index(symbol)]; }

}  // namespace evc
