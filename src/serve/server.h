#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "io/diagnostic.h"
#include "serve/conversation.h"
#include "serve/session.h"

namespace evc::serve {

struct ServerOptions {
  std::uint16_t port = 0;  ///< 0: any that is free
  Manner manner;
  std::size_t most_sessions = 64;
  Room room;
};

/// Units behind one port of the loopback interface. A connection that begins as HTTP is a browser's: the page at `/`,
/// and at `/unit` a session by WebSocket, for that page and for programs only. Any other is a session of lines.
/// Each session has a unit and a thread of its own; the network is one thread, that of `run`.
class Server {
 public:
  /// Takes connections from now on, which wait until `run`. The error of a port that cannot be had.
  static io::Result<std::unique_ptr<Server>> open(const ServerOptions& options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  std::uint16_t port() const;
  /// Until `stopped` says so, which is asked ten times a second; then every session is ended. Once.
  void run(const std::function<bool()>& stopped);

 private:
  struct Network;
  explicit Server(std::unique_ptr<Network> network);
  std::unique_ptr<Network> network_;
};

}  // namespace evc::serve
