#include "lang/telegram.h"
#include "language.h"

// The first byte chooses direction and version, the others are the message. The message is read a
// second time with the correct L_MESSAGE, so that the fuzzer gets past this check.
namespace {

template <class View>
void check(const View& view) {
  if (view.fault != evc::lang::Fault::none) return;
  for (const evc::lang::PacketView& packet : view.packets) evc::fuzz::check_view(packet, true);
}

void look(std::span<const std::uint8_t> bytes, evc::lang::Direction direction, evc::lang::SystemVersion sv) {
  using namespace evc;
  if (direction == lang::Direction::to_train)
    check(lang::scan_message_to_train(bytes, sv));
  else
    check(lang::scan_message_to_track(bytes, sv));
  if (bytes.empty() || !fuzz::is_selected(bytes)) return;
  io::explain_radio(bytes, direction, sv);
  for (const io::Spare spare : {io::Spare::refuse, io::Spare::accept}) {
    std::string json;
    if (!io::append_radio_json(json, bytes, direction, sv, spare)) continue;
    const auto encoded = io::encode_radio_json(nlohmann::json::parse(json), {direction, sv});
    fuzz::require(encoded.has_value());
    fuzz::require(encoded->bytes == std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace evc;
  if (size < 2) return 0;
  const auto direction = (data[0] & 1) != 0 ? lang::Direction::to_track : lang::Direction::to_train;
  constexpr lang::SystemVersion versions[]{{1, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}, {2, 3}, {3, 0}};
  const lang::SystemVersion sv = versions[(data[0] >> 1) & 3];
  std::vector<std::uint8_t> message(data + 1, data + size);
  look(message, direction, sv);
  if (message.size() < 3 || message.size() > 1023) return 0;
  message[1] = static_cast<std::uint8_t>(message.size() >> 2);
  message[2] = static_cast<std::uint8_t>((message[2] & 0x3F) | ((message.size() & 3) << 6));
  look(message, direction, sv);
  return 0;
}
