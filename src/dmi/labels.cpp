#include "dmi/labels.h"

#include <array>

namespace evc::dmi {
namespace {

struct LanguageRow {
  std::string_view code, name;
};
constexpr auto kLanguages = std::to_array<LanguageRow>(
    {LanguageRow{"bg", "Български"}, LanguageRow{"cs", "Čeština"}, LanguageRow{"da", "Dansk"},
     LanguageRow{"de", "Deutsch"}, LanguageRow{"en", "English"}, LanguageRow{"es", "Español"},
     LanguageRow{"fi", "Suomi"}, LanguageRow{"fr", "Français"}, LanguageRow{"hr", "Hrvatski"},
     LanguageRow{"hu", "Magyar"}, LanguageRow{"it", "Italiano"}, LanguageRow{"nl", "Nederlands"},
     LanguageRow{"no", "Norsk"}, LanguageRow{"pl", "Polski"}, LanguageRow{"pt", "Português"},
     LanguageRow{"ro", "Română"}, LanguageRow{"sk", "Slovenčina"}, LanguageRow{"sl", "Slovenščina"},
     LanguageRow{"sv", "Svenska"}});

constexpr std::array<std::string_view, static_cast<std::size_t>(FieldId::count)> kLabels{
    "Driver ID",
    "Train running number",
    "Level",
    "Language",
    "Volume",
    "Brightness",
    "VBC code",
    "VBC code",
    "ATO",
    "Adhesion",
    "SR speed (km/h)",
    "SR distance (m)",
    "RBC ID",
    "RBC phone number",
    "GSM-R network ID",
    "Radio network type",
    "Mission with one radio system",
    "Train type",
    "Train category",
    "Length (m)",
    "Brake percentage",
    "Maximum speed (km/h)",
    "Axle load category",
    "Airtight",
    "Loading gauge",
    "Validation"};
constexpr std::string_view kNetworkBefore400 = "Radio network ID";

}  // namespace

bool has_ntc_name(const port::Display& display, std::uint8_t nid_ntc) {
  for (const port::NtcName& named : display.config.ntc_names)
    if (named.nid_ntc == nid_ntc && !until_zero(named.characters).empty()) return true;
  return false;
}

Words ntc_label(const port::Display& display, std::uint8_t nid_ntc) {
  Words words;
  for (const port::NtcName& named : display.config.ntc_names)
    if (named.nid_ntc == nid_ntc) append_latin(words, until_zero(named.characters));
  if (!words.empty()) return words;
  words.append("NTC ");
  append_number(words, nid_ntc);
  return words;
}

std::string_view fixed_text(std::uint8_t Q_TEXT) {
  constexpr std::array<std::string_view, 3> kFixed{"Level crossing not protected", "Acknowledgement",
                                                   "Text of the trackside"};
  return kFixed[Q_TEXT < 2 ? Q_TEXT : 2];
}

std::string_view label(FieldId id, SrsVersion srs) {
  if (id == FieldId::network && srs != SrsVersion::v4_0_0) return kNetworkBefore400;
  return id < FieldId::count ? kLabels[static_cast<std::size_t>(id)] : std::string_view{};
}

Words label(Button button, SrsVersion srs) {
  return button == Button::gsmr_network_id ? Words{label(FieldId::network, srs)} : Words{name(button)};
}

std::string_view language_name(Language language) {
  for (const LanguageRow& row : kLanguages)
    if (row.code == language.view()) return row.name;
  return {};
}

}  // namespace evc::dmi
