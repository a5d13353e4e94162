#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "openevc/terms/level.h"
#include "openevc/terms/mode.h"
#include "openevc/terms/requests.h"
#include "openevc/terms/symbol.h"

// The symbols of modes, levels and what is to be acknowledged (ERA_ERTMS_015560 8.2.3.1, 8.2.3.2).
namespace evc {

/// The symbol of a mode (MO11), none for NP, PS, SL and IS. That of SN is the national system's to show.
constexpr std::optional<Symbol> symbol(Mode mode) {
  constexpr std::array<std::optional<Symbol>, kModes> symbols{
      /* NP */ std::nullopt, /* SB */ Symbol::MO13, /* PS */ std::nullopt,
      /* SH */ Symbol::MO01, /* FS */ Symbol::MO11, /* LS */ Symbol::MO21,
      /* SR */ Symbol::MO09, /* OS */ Symbol::MO07, /* SL */ std::nullopt,
      /* NL */ Symbol::MO12, /* UN */ Symbol::MO16, /* TR */ Symbol::MO04,
      /* PT */ Symbol::MO06, /* SF */ Symbol::MO18, /* IS */ std::nullopt,
      /* SN */ Symbol::MO19, /* RV */ Symbol::MO14,
      /* SM */ Symbol::MO24, /* AD */ Symbol::MO23};
  const auto place = static_cast<std::size_t>(mode);
  return place < symbols.size() ? symbols[place] : std::nullopt;
}

/// The symbol that asks for the acknowledgement of a mode or of the trip (MO08), none for the other acknowledgements.
constexpr std::optional<Symbol> symbol(Ack ack) {
  switch (ack) {
    case Ack::SH:
      return Symbol::MO02;
    case Ack::trip:
      return Symbol::MO05;
    case Ack::OS:
      return Symbol::MO08;
    case Ack::SR:
      return Symbol::MO10;
    case Ack::RV:
      return Symbol::MO15;
    case Ack::UN:
      return Symbol::MO17;
    case Ack::SN:
      return Symbol::MO20;
    case Ack::LS:
      return Symbol::MO22;
    default:
      return std::nullopt;
  }
}

/// The symbol of a level (LE04).
constexpr Symbol symbol(Level level) {
  constexpr std::array<Symbol, kLevels> symbols{Symbol::LE01, Symbol::LE02, Symbol::LE03, Symbol::LE04, Symbol::LE05};
  return symbols[static_cast<std::size_t>(level) % kLevels];
}

/// The symbol of an announced level, with (yellow) or without acknowledgement. Levels 1, 2 and 3 have a yellow one only
/// up to 3.6.0, for a transition from level NTC; 015560 of 4.0.0 has none, and LE11, LE13 and LE15 are used instead.
constexpr Symbol announcement_symbol(Level level, bool acknowledgement) {
  constexpr std::array<Symbol, kLevels> grey{Symbol::LE06, Symbol::LE08, Symbol::LE10, Symbol::LE12, Symbol::LE14};
  constexpr std::array<Symbol, kLevels> yellow{Symbol::LE07, Symbol::LE09, Symbol::LE11, Symbol::LE13, Symbol::LE15};
  return (acknowledgement ? yellow : grey)[static_cast<std::size_t>(level) % kLevels];
}

}  // namespace evc
