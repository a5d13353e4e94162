#include "kernel/report/asked.h"

namespace evc::kernel {
namespace {

using port::AskedAck;

using Queue = decltype(Displayed::acks);

bool same(const AskedAck& a, const AskedAck& b) { return a.what == b.what && a.id == b.id; }

bool contains(const Queue& queue, const AskedAck& asked) {
  for (const AskedAck& one : queue)
    if (same(one, asked)) return true;
  return false;
}

/// Texts of the trackside and of the unit that wait.
void add_texts(const Outputs& out, Duration now, Queue& asked) {
  for (const ShownText& text : out.texts)
    if (text.acknowledge) (void)asked.push_back({Ack::text, text.id, now});
  for (const ShownStatus& status : out.status_texts)
    if (asks_acknowledgement(status.text))
      (void)asked.push_back({Ack::text, static_cast<std::uint16_t>(kFirstStatusId + terms::index(status.text)), now});
}

}  // namespace

void queue_acknowledgements(State& s, Set<Ack> requests, const Outputs& out) {
  Queue& queue = s.displayed.acks;
  if (requests.empty()) {
    queue.clear();
    return;
  }
  // At most one of each kind, and the texts: there is room for all.
  Queue asked;
  for (std::size_t i = 0; i < terms::index(Ack::count); ++i) {
    const Ack ack = static_cast<Ack>(i);
    if (ack != Ack::text && requests.has(ack)) (void)asked.push_back({ack, 0, s.now});
  }
  if (requests.has(Ack::text)) add_texts(out, s.now, asked);
  queue.erase_if([&asked](const AskedAck& one) { return !contains(asked, one); });
  for (const AskedAck& one : asked)
    if (!contains(queue, one)) (void)queue.push_back(one);
}

}  // namespace evc::kernel
