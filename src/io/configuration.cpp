#include "io/input_stream.h"
#include "io/latin1.h"

// Apart from the reader of streams: WebAssembly has none.
namespace evc::io {

kernel::Config Configuration::for_kernel() const {
  kernel::Config config;
  config.srs = srs;
  config.train = train.data;
  config.national_values = national_values;
  config.L_engine = L_engine;
  config.levels = levels;
  config.identity = identity;
  config.contact = contact;
  config.networks = networks;
  config.dial = dial;
  for (const auto& [nid_ntc, name] : ntc_names) {
    port::NtcName short_name{.nid_ntc = nid_ntc};
    latin1_of(name).copy(short_name.characters.data(), short_name.characters.size());
    if (!config.ntc_names.push_back(short_name)) break;  // read_ntc_names takes no more
  }
  config.terminals = terminals.value_or(config.terminals);
  config.by_train = by_train;
  config.local_time_offset_min = local_time_offset_min;
  return config;
}

}  // namespace evc::io
