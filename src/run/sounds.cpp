#include "run/sounds.h"

namespace evc::run {

void Sounds::append(std::vector<io::NamedSound>& sounds, const kernel::Display& record) {
  dmi::show(*display_, record);
  const dmi::Commands commands = dmi::take(*display_);
  for (const dmi::SoundOrder& order : commands.sounds)
    sounds.push_back({dmi::name(order.sound), order.what == dmi::SoundDo::once   ? nullptr
                                              : order.what == dmi::SoundDo::loop ? "loop"
                                                                                 : "stop"});
}

}  // namespace evc::run
