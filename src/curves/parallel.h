#pragma once
#include <cstddef>
#include <functional>

namespace evc::curves {

/// Calls `job(worker, i)` for i = 0 to `jobs` - 1, each once, with workers 0 to `threads` - 1, each of which is one
/// thread at a time. An exception of a job is thrown here, when no thread works any more. `progress`, if any, gets the
/// share that is done, in the caller's thread, which does not work itself then.
void in_threads(unsigned threads, std::size_t jobs, const std::function<void(unsigned, std::size_t)>& job,
                const std::function<void(double)>& progress = {});

}  // namespace evc::curves
