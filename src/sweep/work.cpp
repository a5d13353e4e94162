#include "sweep/work.h"

#include "io/json.h"
#include "sweep/kinds.h"

namespace evc::sweep {

io::Result<std::unique_ptr<Work>> make_work(const Spec& spec) {
  return io::guarded([&] {
    switch (spec.kind) {
      case Kind::curves:
        return make_curves_work(spec);
      case Kind::replay:
        return make_replay_work(spec);
      default:
        return make_run_work(spec);
    }
  });
}

}  // namespace evc::sweep
