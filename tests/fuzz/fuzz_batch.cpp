// Any text as a batch of queries is rejected with its place, or gives every train with every target.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "curves/batch_queries.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const evc::curves::BatchText all = evc::curves::documents_of(text);
  if (all.documents.empty()) std::abort();
  for (const auto& document : all.documents) {
    const auto query = evc::curves::BatchQuery::read(document.text, "fuzz.jsonl", document.where);
    // A train may be the name of another file, which is named then.
    if (!query && query.error().text().find(": found ") == std::string::npos) std::abort();
    if (!query) continue;
    if (query->trains() == 0 || query->targets() == 0) std::abort();
    const std::size_t last = query->trains() - 1;
    const auto input = query->input(last, query->targets() - 1);
    if (last == 0 && !input) std::abort();  // it was read before
    if (input && !(query->target(0).SvL >= query->target(0).location)) std::abort();
  }
  return 0;
}
