#include "lang/telegram.h"
#include "language.h"

// User bits of a balise telegram; the same bits as a Euroloop message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace evc;
  const std::span bytes(data, size);
  const std::size_t bits = size * 8;
  const lang::TelegramView all = lang::scan_telegram(bytes, bits);
  const lang::TelegramView found = lang::scan_telegram(bytes, bits, lang::Check::structure);
  if (all.fault == lang::Fault::none) {
    fuzz::require(found.fault == lang::Fault::none && found.packets.size() == all.packets.size());
    for (const lang::PacketView& view : all.packets) fuzz::check_view(view, true);
  }
  if (all.fault != lang::Fault::none)
    for (const lang::PacketView& view : found.packets) fuzz::check_view(view, false);
  const lang::LoopMessageView loop = lang::scan_loop_message(bytes, bits);
  if (loop.fault == lang::Fault::none)
    for (const lang::PacketView& view : loop.packets) fuzz::check_view(view, true);
  if (!fuzz::is_selected(bytes)) return 0;
  const bool readable = lang::scan_telegram(bytes, bits, lang::Check::reading).fault == lang::Fault::none;
  bool ignored = false;  // the contents of one packet do not count
  for (const lang::PacketView& view : all.packets) ignored = ignored || fuzz::is_ignored(view);
  fuzz::require(readable || ignored || all.fault != lang::Fault::none);
  io::explain_balise(bytes, bits);
  for (const io::Spare spare : {io::Spare::refuse, io::Spare::accept}) {
    std::string json;
    if (io::append_balise_json(json, bytes, bits, spare)) {
      fuzz::require(spare == io::Spare::accept || readable);
      const auto encoded = io::encode_balise_json(nlohmann::json::parse(json));
      fuzz::require(encoded.has_value());
      std::string again;
      fuzz::require(io::append_balise_json(again, encoded->bytes, encoded->bits, spare).has_value());
      fuzz::require(again == json);
    }
    json.clear();
    if (io::append_loop_json(json, bytes, bits, spare))
      fuzz::require(io::encode_loop_json(nlohmann::json::parse(json)).has_value());
  }
  return 0;
}
