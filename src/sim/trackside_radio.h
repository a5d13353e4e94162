#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "port/inputs.h"
#include "port/outputs.h"
#include "sim/cycle_inputs.h"
#include "sim/line.h"
#include "sim/random.h"

namespace evc::sim {

/// A delivered message.
struct Delivery {
  std::int64_t t_ms = 0;
  double front_m = 0.0;
  int seq = -1;  // of the recorded message; -1: made by the simulated radio
  std::uint8_t NID_MESSAGE = 0;
};

/// The radio bearer and a simulated RBC: it answers the messages of the on-board (session set-up and end, train data,
/// start of mission, requests for an authority and for shunting), sends the messages of the line when the front end
/// reaches their places, stamped with the time of delivery, and a general message after 20 s without messages. It has
/// no other functions.
class TracksideRadio {
 public:
  /// `last_ma`: messages with a movement authority and a higher `seq` are withheld.
  TracksideRadio(const Line& line, std::optional<int> last_ma, Random& random);

  /// Takes the orders to the bearer and the messages that the on-board sent in the cycle at `t_ms`.
  void hear(const port::Outputs& outputs, std::int64_t t_ms);
  /// Adds the messages that arrive in the cycle at `t_ms` to its inputs.
  void deliver(std::int64_t t_ms, double front_m, CycleInputs& inputs);

  const std::vector<Delivery>& deliveries() const { return deliveries_; }
  /// Number of messages of the line whose place was reached and that are not delivered.
  std::size_t undelivered() const { return reached_.size(); }
  /// Those of them that arrive by themselves, after their delay; without a session none does.
  std::size_t waiting() const;
  std::size_t withheld() const { return withheld_; }
  bool session() const { return session_; }
  /// Calls of an RBC other than the one that was called first, or of a radio infill unit: nobody answers them.
  std::size_t unanswered_calls() const { return unanswered_calls_; }

 private:
  struct Reply {
    std::int64_t due_ms = 0;
    Bits message;
  };
  struct Reached {
    std::int64_t due_ms = 0;
    std::size_t message = 0;  // index in the line
  };
  void hear_call(const port::RbcAddress& called, std::int64_t t_ms);
  void answer(const port::OutgoingMessage& message, std::int64_t t_ms);
  void answer_ma_request(std::uint32_t Q_MARQSTREASON, std::int64_t t_ms);
  bool is_withheld(const TracksideMessage& message) const;
  bool needs_a_group(const TracksideMessage& message) const;
  void reply(std::int64_t t_ms, Bits message);
  void send(Bits message, int seq, std::int64_t t_ms, double front_m, CycleInputs& inputs);

  const Line& line_;
  std::optional<int> last_ma_;
  Random& random_;
  std::uint8_t M_VERSION_ = 33;  // of the line's telegrams
  std::optional<port::RbcAddress> called_;
  std::size_t unanswered_calls_ = 0;
  std::optional<std::int64_t> connected_at_ms_;
  bool bearer_ = false, session_ = false;
  std::uint32_t NID_LRBG_ = 0xFFFFFF;  // as last reported
  bool position_unknown_ = false;      // reported at start of mission, and no group since
  std::optional<std::uint32_t> last_stamp_;
  std::int64_t last_sent_ms_ = 0;
  std::size_t next_ = 0;
  std::size_t withheld_ = 0;
  std::vector<Reply> replies_;
  std::vector<Reached> reached_;
  std::vector<Delivery> deliveries_;
};

}  // namespace evc::sim
