#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "port/inputs.h"
#include "port/outputs.h"
#include "sim/line.h"
#include "train/train_data.h"

namespace evc::sim {

/// The inputs of one cycle with the bytes they refer to. `levels` keeps its value from cycle to cycle, `clear` deletes
/// what belongs to one cycle only.
struct CycleInputs {
  struct Telegram {
    Bits bits;
    OdometerPlace at;
    std::optional<Duration> passed = {};  // the time instead
  };
  /// A radio message, and the RBC it is from where the stream names it.
  struct RadioMessage : Bits {
    std::optional<port::RbcIdentity> from;
    bool infill_unit = false;  ///< from a radio infill unit
  };
  std::int64_t t_ms = 0;
  port::Inputs levels;  // odometry, driver actions, signals; its spans are set by view()
  std::vector<Telegram> balises;
  std::vector<Bits> loops;
  std::vector<RadioMessage> radio;
  std::optional<train::TrainData> train_data;           // entered in this cycle
  std::optional<train::TrainData> external_train_data;  // from another source than the driver, in this cycle

  void clear();
  /// The kernel's view; valid until this object is changed.
  const port::Inputs& view();

 private:
  std::vector<port::BaliseTelegram> balise_views_;
  std::vector<port::LoopMessage> loop_views_;
  std::vector<port::RadioMessage> radio_views_;
};

}  // namespace evc::sim
