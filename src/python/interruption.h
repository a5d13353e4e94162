#pragma once
#include <pybind11/pybind11.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace evc::python {

/// The end of the process: static data is deleted then, so nothing may compute any more. Python waits for no thread
/// that is a daemon.
struct ProcessEnd {
  inline static std::atomic<bool> near{false};
  inline static std::atomic<int> computations{0};
  inline static std::thread::id ending;  ///< the thread that ends the interpreter; read when `near`

  /// Called by Python before it ends, with the lock: each computation ends soon.
  static void come() {
    ending = std::this_thread::get_id();
    near = true;
    const pybind11::gil_scoped_release unlocked;
    const auto latest = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    while (computations > 0 && std::chrono::steady_clock::now() < latest)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
};

/// The interpreter works on in other threads, until the end of the scope. The caller has its lock.
class Unlocked {
 public:
  Unlocked() : state_((++ProcessEnd::computations, PyEval_SaveThread())) {}
  ~Unlocked() {
    // Who would wait for the lock while the interpreter ends does not ask for it: only threads are left for which
    // nobody waits. Who asked before has it before the end goes on.
    if (ProcessEnd::near && std::this_thread::get_id() != ProcessEnd::ending) {
      --ProcessEnd::computations;
      wait_for_the_end();
    }
    lock();
    --ProcessEnd::computations;
  }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

  /// Does something with the lock.
  template <class F>
  auto with_lock(F&& f) {
    lock();
    const Again again{*this};
    return f();
  }

 private:
  struct Again {
    Unlocked& unlocked;
    ~Again() { unlocked.state_ = PyEval_SaveThread(); }
  };
  /// When the interpreter ends, a thread that it does not wait for cannot have the lock any more: the interpreter ends
  /// the thread instead, by unwinding its stack, which functions of C++ do not allow. It then waits for the end of the
  /// process.
  void lock() noexcept {
    try {
      PyEval_RestoreThread(state_);
    } catch (...) {
      wait_for_the_end();
    }
  }
  [[noreturn]] static void wait_for_the_end() noexcept {
    for (;;) ::pause();
  }

  PyThreadState* state_;
};

/// Lets Python act on signals (Ctrl-C) while a long computation runs without its lock: `seen` takes the lock from time
/// to time. What a signal's handler threw is kept until the computation has left its results whole.
class Interruption {
 public:
  /// Whether the computation is to end. To be asked often: it looks ten times a second at most.
  bool seen(Unlocked& unlocked) {
    if (error_ || ProcessEnd::near) return true;
    const auto now = Clock::now();
    if (now - looked_ < kEvery) return false;
    looked_ = now;
    return unlocked.with_lock([this] { return look(); });
  }
  /// The exception of the handler; None where there was no signal. With the lock.
  pybind11::object error() const { return error_ ? error_ : pybind11::object(pybind11::none()); }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kEvery{100};

  bool look() {
    if (PyErr_CheckSignals() == 0) return false;
    PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
    PyErr_Fetch(&type, &value, &trace);
    PyErr_NormalizeException(&type, &value, &trace);
    if (trace != nullptr) PyException_SetTraceback(value, trace);
    Py_XDECREF(type);
    Py_XDECREF(trace);
    error_ = pybind11::reinterpret_steal<pybind11::object>(value);
    return true;
  }

  Clock::time_point looked_ = Clock::now();
  pybind11::object error_;
};

}  // namespace evc::python
