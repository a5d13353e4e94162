#include "cluster/messenger.h"

#include <mpi.h>

#include <array>
#include <climits>
#include <cstdlib>
#include <deque>
#include <stdexcept>
#include <utility>

namespace evc::cluster {
namespace {

/// What a slow receiver may leave in the memory of a sender.
constexpr std::size_t kMostOnTheirWay = 16;

int size_of(const std::string& bytes) {
  if (bytes.size() > static_cast<std::size_t>(INT_MAX)) throw std::length_error("a message of more than 2 GiB");
  return static_cast<int>(bytes.size());
}

}  // namespace

struct Messenger::Sending {
  struct One {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  std::deque<One> messages;  // the oldest first; they do not move, and MPI reads from them
};

Messenger::Messenger(int& argc, char**& argv) : sending_(std::make_unique<Sending>()) {
  int provided = MPI_THREAD_SINGLE;
  (void)MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  if (provided < MPI_THREAD_FUNNELED) throw std::runtime_error("MPI without threads (MPI_THREAD_SINGLE)");
  (void)MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  (void)MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
}

Messenger::~Messenger() {
  let_go(0);
  (void)MPI_Finalize();
}

std::string Messenger::computer() {
  std::array<char, MPI_MAX_PROCESSOR_NAME> name{};
  int length = 0;
  (void)MPI_Get_processor_name(name.data(), &length);
  return {name.data(), static_cast<std::size_t>(length)};
}

std::string Messenger::broadcast(std::string bytes) const {
  int size = size_of(bytes);
  (void)MPI_Bcast(&size, 1, MPI_INT, 0, MPI_COMM_WORLD);
  bytes.resize(static_cast<std::size_t>(size));
  (void)MPI_Bcast(bytes.data(), size, MPI_BYTE, 0, MPI_COMM_WORLD);
  return bytes;
}

void Messenger::send(int to, Kind kind, std::string bytes) {
  let_go(kMostOnTheirWay);
  Sending::One& one = sending_->messages.emplace_back();
  one.bytes = std::move(bytes);
  // NOLINTNEXTLINE(clang-analyzer-optin.mpi.MPI-Checker): let_go waits for it
  (void)MPI_Isend(one.bytes.data(), size_of(one.bytes), MPI_BYTE, to, static_cast<int>(kind), MPI_COMM_WORLD,
                  &one.request);
}

std::optional<Message> Messenger::received() {
  int there = 0;
  MPI_Status status{};
  (void)MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  int size = 0;
  (void)MPI_Get_count(&status, MPI_BYTE, &size);
  Message message{status.MPI_SOURCE, static_cast<Kind>(status.MPI_TAG),
                  std::string(static_cast<std::size_t>(size), '\0')};
  (void)MPI_Recv(message.bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
  return message;
}

void Messenger::abort(int status) {
  (void)MPI_Abort(MPI_COMM_WORLD, status);
  std::abort();  // MPI_Abort does not return
}

void Messenger::let_go(std::size_t most) {
  auto& messages = sending_->messages;
  while (!messages.empty()) {
    // NOLINTBEGIN(clang-analyzer-optin.mpi.MPI-Checker): their calls are in `send`
    int gone = 0;
    if (messages.size() > most)
      (void)MPI_Wait(&messages.front().request, MPI_STATUS_IGNORE);
    else if ((void)MPI_Test(&messages.front().request, &gone, MPI_STATUS_IGNORE); gone == 0)
      return;
    // NOLINTEND(clang-analyzer-optin.mpi.MPI-Checker)
    messages.pop_front();
  }
}

}  // namespace evc::cluster
