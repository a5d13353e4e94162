#pragma once
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "serve/server.h"

// A server in a thread, and partners of it, which speak through plain sockets.
namespace evc::serve {

class RunningServer {
 public:
  explicit RunningServer(const ServerOptions& options = {}) : server_(opened(options)) {
    thread_ = std::jthread([this] { server_->run([this] { return stop_.load(); }); });
  }
  ~RunningServer() { stop_ = true; }
  std::uint16_t port() const { return server_->port(); }

 private:
  static std::unique_ptr<Server> opened(const ServerOptions& options) {
    auto server = Server::open(options);
    if (!server) throw std::runtime_error(server.error().text());
    return std::move(*server);
  }
  std::unique_ptr<Server> server_;
  std::atomic<bool> stop_ = false;
  std::jthread thread_;
};

/// Nothing takes this long, on any machine: then the test fails instead of waiting.
constexpr int kForeverMs = 120'000;

/// A connection. What it waits for too long, and what it cannot send, throws.
class Client {
 public:
  explicit Client(std::uint16_t port, bool ipv6 = false)
      : socket_(::socket(ipv6 ? AF_INET6 : AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const sockaddr_in6 to6 = loopback6(port);
    const auto* const address = ipv6 ? reinterpret_cast<const sockaddr*>(&to6) : reinterpret_cast<const sockaddr*>(&to);
    if (::connect(socket_, address, ipv6 ? sizeof to6 : sizeof to) != 0) throw std::runtime_error("cannot connect");
  }
  /// Whether ::1 is an address of this machine.
  static bool has_ipv6() {
    const int socket = ::socket(AF_INET6, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (socket < 0) return false;
    const sockaddr_in6 any_port = loopback6(0);
    const bool bound = ::bind(socket, reinterpret_cast<const sockaddr*>(&any_port), sizeof any_port) == 0;
    ::close(socket);
    return bound;
  }
  ~Client() { close(); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  void close() {
    if (socket_ >= 0) ::close(std::exchange(socket_, -1));
  }
  /// The other side finds an error instead of an end.
  void reset() {
    const linger at_once{1, 0};
    (void)::setsockopt(socket_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    close();
  }
  void end() { (void)::shutdown(socket_, SHUT_WR); }

  /// False when the other side does not listen any more.
  bool try_send(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t n = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (n <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
  }
  void send(std::string_view bytes) {
    if (!try_send(bytes)) throw std::runtime_error("cannot send");
  }

  /// The next line, without its end; what there is at the end of the connection.
  std::string line() {
    std::size_t end = 0;
    while ((end = buffer_.find('\n')) == std::string::npos)
      if (!more()) return std::exchange(buffer_, "");
    std::string text = buffer_.substr(0, end);
    buffer_.erase(0, end + 1);
    return text;
  }
  /// Everything up to the end of the connection.
  std::string rest() {
    while (more()) {
    }
    return std::exchange(buffer_, "");
  }
  std::string bytes(std::size_t count) {
    while (buffer_.size() < count && more()) {
    }
    std::string text = buffer_.substr(0, count);
    buffer_.erase(0, count);
    return text;
  }

 private:
  static sockaddr_in6 loopback6(std::uint16_t port) {
    sockaddr_in6 address{};
    address.sin6_family = AF_INET6;
    address.sin6_port = htons(port);
    address.sin6_addr = in6addr_loopback;
    return address;
  }
  bool more() {
    pollfd wanted{socket_, POLLIN, 0};
    if (::poll(&wanted, 1, kForeverMs) != 1) throw std::runtime_error("nothing comes");
    char block[65536];
    const ssize_t n = ::recv(socket_, block, sizeof block, 0);
    if (n <= 0) return false;
    buffer_.append(block, static_cast<std::size_t>(n));
    return true;
  }

  int socket_;
  std::string buffer_;
};

/// A request of HTTP with further header fields, each with its end; the answer up to the end of its header.
inline std::string asked(Client& client, const std::string& request, const std::string& fields) {
  client.send(request + " HTTP/1.1\r\n" + fields + "\r\n");
  std::string answer;
  for (std::string line = client.line(); line.size() > 1; line = client.line()) answer += line + "\n";
  return answer;
}

inline std::string host_of(std::uint16_t port) { return "Host: 127.0.0.1:" + std::to_string(port) + "\r\n"; }
constexpr const char* kUpgrade =
    "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";

/// A WebSocket at /unit (RFC 6455). Masked with zeros, which leaves the bytes as they are.
class WebClient {
 public:
  explicit WebClient(std::uint16_t port, const std::string& fields = "", const std::string& target = "/unit")
      : client_(port) {
    answer_ = asked(client_, "GET " + target, host_of(port) + kUpgrade + fields);
  }
  /// The header of the answer to the request.
  const std::string& answer() const { return answer_; }
  bool taken() const { return answer_.find(" 101 ") != std::string::npos; }

  void send(std::string_view message, bool last = true, bool first = true) {
    std::string frame(1, static_cast<char>((last ? 0x80 : 0) | (first ? 1 : 0)));
    const std::size_t size = message.size();
    const int length_bytes = size < 126 ? 0 : size < 65536 ? 2 : 8;
    frame += static_cast<char>(0x80 | (length_bytes == 0 ? size : length_bytes == 2 ? 126u : 127u));
    for (int n = length_bytes - 1; n >= 0; --n) frame += static_cast<char>(size >> (8 * n));
    frame.append(4, '\0').append(message);
    (void)client_.try_send(frame);
  }
  /// The next message, of as many frames as it has; empty at the end of the session.
  std::string message() {
    std::string text;
    for (bool last = false; !last;) {
      const std::string head = client_.bytes(2);
      if (head.size() < 2 || (head[0] & 0x0F) != (text.empty() ? 1 : 0)) return "";
      last = (head[0] & 0x80) != 0;
      text += payload(head);
    }
    return text;
  }
  void close() { client_.close(); }

 private:
  /// Of the frame with these two bytes at its begin.
  std::string payload(const std::string& head) {
    std::size_t size = head[1] & 0x7F;
    if (size < 126) return client_.bytes(size);
    const std::string length = client_.bytes(size == 126 ? 2 : 8);
    size = 0;
    for (const char c : length) size = size << 8 | static_cast<unsigned char>(c);
    return client_.bytes(size);
  }

  Client client_;
  std::string answer_;
};

}  // namespace evc::serve
