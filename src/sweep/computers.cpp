#include "sweep/computers.h"

#include <algorithm>
#include <thread>

namespace evc::sweep {

io::Result<bool> Threads::prepare(const Plan&) { return true; }

void Threads::compute(const Plan& plan, Todo& todo, unsigned threads, const Take& take) {
  const auto most = static_cast<unsigned>(std::min<std::uint64_t>(todo.left(), 1024));
  const unsigned wanted = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  sweep::compute(plan, todo, std::min(wanted, most), take);
}

}  // namespace evc::sweep
