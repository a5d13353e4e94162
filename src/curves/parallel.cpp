#include "curves/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace evc::curves {

void in_threads(unsigned threads, std::size_t jobs, const std::function<void(unsigned, std::size_t)>& job,
                const std::function<void(double)>& progress) {
  std::atomic<std::size_t> next = 0, done = 0;
  std::mutex mutex;
  std::condition_variable ended;
  const auto workers = static_cast<unsigned>(std::clamp<std::size_t>(jobs, 1, std::max(1U, threads)));
  unsigned working = workers;
  std::exception_ptr failure;
  const auto work = [&](unsigned worker) {
    try {
      for (std::size_t i = next++; i < jobs; i = next++) {
        job(worker, i);
        ++done;
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
      next = jobs;
    }
    const std::lock_guard lock(mutex);
    --working;
    ended.notify_all();
  };
  {
    std::vector<std::jthread> pool;
    for (unsigned worker = progress ? 0 : 1; worker < workers; ++worker) pool.emplace_back(work, worker);
    if (!progress) work(0);
    std::unique_lock lock(mutex);
    while (!ended.wait_for(lock, std::chrono::milliseconds(100), [&] { return working == 0; })) {
      const double share = static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(jobs, 1));
      lock.unlock();
      if (progress) progress(share);
      lock.lock();
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace evc::curves
