#include "deceleration/command.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "deceleration/guaranteed.h"
#include "deceleration/plot.h"
#include "deceleration/report.h"
#include "deceleration/train_document.h"
#include "io/file.h"
#include "io/terminal_line.h"

namespace evc::deceleration {
namespace {

using io::complain;

constexpr std::size_t kBarWidth = 30;

/// The files that are to be written: opened before anything is computed, so that an error comes first.
struct Files {
  std::optional<io::WholeFile> plot, train;
};
io::Result<Files> open(const Options& options) {
  Files files;
  if (!options.plot.empty() && !options.plot.ends_with(".svg"))
    return tl::unexpected(io::Diagnostic{"evc brakes", "--plot", options.plot, "FILE.svg"});
  if (!options.plot.empty() && !options.output.empty() && io::same_file(options.plot, options.output))
    return tl::unexpected(io::Diagnostic{"evc brakes", "--plot", options.plot, "another file than -o"});
  for (const auto& [name, file] : {std::pair(&options.plot, &files.plot), std::pair(&options.output, &files.train)}) {
    if (name->empty()) continue;
    if (const auto apart = io::not_the_input(options.spec, *name); !apart) return tl::unexpected(apart.error());
    auto created = io::WholeFile::create(*name);
    if (!created) return tl::unexpected(created.error());
    file->emplace(*std::move(created));
  }
  return files;
}

io::Result<bool> write(Files& files, const Spec& spec, const Guaranteed& result) {
  if (files.train) {
    const auto document =
        train_document(spec, train_steps(spec, result.safe_steps()), result.build_up_at(spec.response_level));
    if (!document) return tl::unexpected(document.error());
    files.train->write(*document);
  }
  if (files.plot) files.plot->write(chart(spec, result));
  if (files.train && files.plot) return io::commit_together({&*files.train, &*files.plot});
  if (files.train) return files.train->commit();
  return files.plot ? files.plot->commit() : io::Result<bool>(true);
}

}  // namespace

int brakes(const Options& options) {
  const auto text = io::read_text(options.spec);
  if (!text) return complain(text.error());
  const auto spec = read_spec(*text, options.spec);
  if (!spec) return complain(spec.error());
  const auto train = check_train(*spec);
  if (!train) return complain(train.error());
  if (!options.output.empty() && !*train)
    return complain({options.spec, "", "no key \"train\"", "the train that -o is to describe: etcs-train/1"});
  auto files = open(options);
  if (!files) return complain(files.error());
  io::TerminalLine line;
  const unsigned threads = options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
  const Guaranteed result = guaranteed(*spec, threads, options.plain, [&](double share) {
    line.show(fmt::format("brakes [{}] {:.0f} %", io::bar_of(share, kBarWidth), 100.0 * share));
  });
  line.clear();
  if (const auto written = write(*files, *spec, result); !written) return complain(written.error());
  // The train file, or the chart, may be on standard output.
  const bool taken = options.output == "-" || options.plot == "-";
  fmt::print(taken ? stderr : stdout, "{}", options.format == "json" ? json(*spec, result) : table(*spec, result));
  return 0;
}

}  // namespace evc::deceleration
