#include "serve/server.h"

#include <array>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <deque>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "serve/access.h"
#include "serve/lines.h"
#include "serve/page.h"

// The only source that knows Boost. One thread runs all handlers of this file, so nothing here is locked; the threads
// of the units reach it by Conversation alone, which posts `Session::advance`.
namespace evc::serve {

namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using tcp = net::ip::tcp;
using boost::system::error_code;

constexpr std::size_t kBlock = 1 << 16;
/// How long a connection may be none of a session: until its first byte, and for a request of HTTP.
constexpr std::chrono::seconds kFirstByte{60}, kRequest{30};
/// A session of the page at `/`: its lines have the record of the display, whatever the options are.
constexpr const char* kUnitWithDisplay = "/unit?dmi";
/// Connections of that kind at a time.
constexpr std::size_t kMostVisitors = 64;
/// How often an end of the program is looked for.
constexpr std::chrono::milliseconds kLook{100};

std::string_view view(boost::beast::string_view text) { return {text.data(), text.size()}; }

class Session;
class Visitor;

/// Everything there is behind the port.
class Hub {
 public:
  Hub(const ServerOptions& options) : options_(options), page_(page()), tick_(io_) {}

  io::Result<bool> listen();
  void run(const std::function<bool()>& stopped);

  const ServerOptions& options() const { return options_; }
  net::io_context& io() { return io_; }
  std::uint16_t port() const { return port_; }
  const std::string& page_at_root() const { return page_; }

  bool has_room() const;
  /// Further ones, which only get the error that there is no room.
  bool can_refuse() const { return sessions_.size() < 2 * options_.most_sessions; }
  io::Diagnostic full() const {
    return {"session", "", std::to_string(options_.most_sessions) + " sessions", "a session less"};
  }
  void add(const std::shared_ptr<Session>& session) { sessions_.insert(session); }
  void forget(const std::shared_ptr<Session>& session) { sessions_.erase(session); }
  void forget(const std::shared_ptr<Visitor>& visitor) { visitors_.erase(visitor); }

 private:
  /// Where connections come in: one of each family of addresses.
  struct Door {
    explicit Door(net::io_context& io) : acceptor(io) {}
    tcp::acceptor acceptor;
    bool accepting = false;
  };
  /// Takes connections at this address.
  error_code open(const tcp::endpoint& wanted);
  void accept(Door& door);
  void look();
  void stop();

  ServerOptions options_;
  std::string page_;
  net::io_context io_{1};
  std::deque<Door> doors_;
  net::steady_timer tick_;
  std::uint16_t port_ = 0;
  std::function<bool()> stopped_;
  std::set<std::shared_ptr<Session>> sessions_;
  std::set<std::shared_ptr<Visitor>> visitors_;
};

/// The network's side of a session: moves lines between a connection and a conversation. `advance` looks at everything
/// and begins what can be begun; each end of something leads to it.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(Hub& hub, const Manner& manner)
      : hub_(hub), manner_(manner), deadline_(hub.io()), conversation_(hub.options().room, [this] { call(); }) {}
  virtual ~Session() {
    conversation_.drop();
    unit_.request_stop();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// A unit begins to answer. The session is one of the hub.
  void begin() {
    work_.emplace(hub_.io().get_executor());
    try {
      unit_ = std::jthread([this](const std::stop_token& stop) { answer(conversation_, manner_, clock_, stop); });
    } catch (const std::system_error& failure) {
      work_.reset();
      return refuse({"session", "", failure.code().message(), "a thread for its unit"});
    }
    advance();
  }
  /// No unit: the partner gets the reason.
  void refuse(const io::Diagnostic& why) {
    refused_ = true;
    conversation_.end_inputs();
    inputs_over_ = true;
    (void)conversation_.give_now(error_line(why));
    conversation_.finish();
  }
  bool refused() const { return refused_; }

  void take(std::string_view bytes) {
    if (inputs_over_) return;
    const realtime::Nanoseconds now = clock_.now();
    if (cutter_.take(bytes, [&](std::string&& text) { conversation_.put({std::move(text), now}); })) return;
    conversation_.put({"", now, true});
    inputs_over_ = true;
  }

  /// The connection ends now, and with it everything.
  void cut() {
    if (closed_) return;
    closed_ = true;
    deadline_.cancel();
    conversation_.drop();
    unit_.request_stop();
    close();
  }

  void advance() {
    conversation_.seen();
    if (conversation_.dropped()) cut();
    const bool finished = conversation_.finished();  // before `take`: nothing comes behind what that gives
    if (may_read()) {
      reading_ = true;
      read();
    }
    if (!closed_ && !sending_ && !leaving_) {
      std::vector<std::string> lines = conversation_.take(kBlock);
      sending_ = !lines.empty();
      if (sending_) send(std::move(lines));
      if (!sending_ && finished) begin_to_leave();
    }
    if (finished) expect_progress();
    if (finished && unit_.joinable()) {
      unit_.join();
      work_.reset();
    }
    if (closed_ && !unit_.joinable()) hub_.forget(shared_from_this());
  }

 protected:
  virtual void read() = 0;
  virtual void send(std::vector<std::string> lines) = 0;
  /// Everything is said: the partner learns the end in the manner of the protocol.
  virtual void leave() = 0;
  virtual void close() = 0;
  /// Whether what still comes is read and dropped while leaving: bytes that nobody reads would make the system forget
  /// what the partner has not read yet.
  virtual bool reads_to_the_end() const = 0;

  void received(std::string_view bytes) {
    reading_ = false;
    take(bytes);
  }
  /// The partner says that nothing more comes, and may still listen.
  void inputs_ended() {
    reading_ = false;
    read_all_ = true;
    if (leaving_) {
      cut();
    } else if (!inputs_over_) {
      inputs_over_ = true;
      if (std::string rest = cutter_.rest(); !rest.empty()) conversation_.put({std::move(rest), clock_.now()});
      conversation_.end_inputs();
    }
  }
  void sent(error_code error) {
    sending_ = false;
    expecting_ = false;
    if (error) cut();
    advance();
  }

 private:
  /// From the thread of the unit too.
  void call() {
    net::post(hub_.io(), [weak = weak_from_this()] {
      if (const auto self = weak.lock()) self->advance();
    });
  }
  bool may_read() const {
    if (closed_ || reading_ || read_all_) return false;
    return leaving_ ? reads_to_the_end() : !inputs_over_ && conversation_.has_room();
  }
  void begin_to_leave() {
    leaving_ = true;
    expecting_ = false;
    leave();
    if (read_all_) cut();
    call();
  }
  /// Behind the last word of the unit a partner who takes nothing is not waited for without end.
  void expect_progress() {
    if (closed_ || expecting_) return;
    expecting_ = true;
    deadline_.expires_after(hub_.options().room.patience);
    deadline_.async_wait([self = shared_from_this()](error_code error) {
      if (error || self->deadline_.expiry() > net::steady_timer::clock_type::now()) return;
      self->cut();
      self->advance();
    });
  }

  Hub& hub_;
  const Manner manner_;
  net::steady_timer deadline_;
  realtime::MonotonicClock clock_;
  Conversation conversation_;
  LineCutter cutter_;
  std::optional<net::executor_work_guard<net::io_context::executor_type>> work_;  // a unit will call
  bool reading_ = false, sending_ = false;                                        // something of that kind is under way
  bool inputs_over_ = false;                                                      // no line more is taken
  bool read_all_ = false;                                                         // the partner has ended its direction
  bool leaving_ = false, closed_ = false, refused_ = false, expecting_ = false;
  std::jthread unit_;  // the last member: it uses the others
};

/// Lines over TCP.
class LineSession final : public Session {
 public:
  LineSession(Hub& hub, beast::tcp_stream stream) : Session(hub, hub.options().manner), stream_(std::move(stream)) {
    stream_.expires_never();
  }

 private:
  std::shared_ptr<LineSession> self() { return std::static_pointer_cast<LineSession>(shared_from_this()); }

  void read() override {
    stream_.async_read_some(net::buffer(block_), [self = self()](error_code error, std::size_t size) {
      if (!error)
        self->received({self->block_.data(), size});
      else if (error == net::error::eof)
        self->inputs_ended();
      else
        self->cut();
      self->advance();
    });
  }
  void send(std::vector<std::string> lines) override {
    text_.clear();
    for (const std::string& line : lines) text_ += line;
    net::async_write(stream_, net::buffer(text_),
                     [self = self()](error_code error, std::size_t) { self->sent(error); });
  }
  void leave() override {
    error_code gone;
    (void)stream_.socket().shutdown(tcp::socket::shutdown_send, gone);
  }
  void close() override { stream_.close(); }
  bool reads_to_the_end() const override { return true; }

  beast::tcp_stream stream_;
  std::array<char, kBlock> block_{};
  std::string text_;
};

/// Lines over WebSocket, one a message.
class WebSession final : public Session {
 public:
  WebSession(Hub& hub, beast::tcp_stream stream, const Manner& manner)
      : Session(hub, manner), socket_(std::move(stream)) {
    beast::get_lowest_layer(socket_).expires_never();
    socket_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    socket_.text(true);
    // A line has its limit, and what waits for the unit; a message of many lines needs none of its own.
    socket_.read_message_max(0);
  }
  void accept(const http::request<http::empty_body>& request) {
    socket_.async_accept(request, [self = self()](error_code error) {
      if (!error) return self->begin();
      self->cut();
      self->advance();
    });
  }

 private:
  std::shared_ptr<WebSession> self() { return std::static_pointer_cast<WebSession>(shared_from_this()); }

  void read() override {
    socket_.async_read_some(buffer_, kBlock, [self = self()](error_code error, std::size_t) {
      if (error)
        self->cut();
      else
        self->read_some();
      self->advance();
    });
  }
  /// The end of a message is that of its last line.
  void read_some() {
    const auto data = buffer_.data();
    const std::string_view bytes(static_cast<const char*>(data.data()), data.size());
    if (!bytes.empty()) ended_ = bytes.back() == '\n';
    received(bytes);
    buffer_.consume(bytes.size());
    if (!socket_.is_message_done()) return;
    if (!ended_) take("\n");
    ended_ = false;
  }
  void send(std::vector<std::string> lines) override {
    lines_ = std::move(lines);
    at_ = 0;
    send_next();
  }
  void send_next() {
    const std::string& line = lines_[at_];
    socket_.async_write(net::buffer(line.data(), line.size() - 1), [self = self()](error_code error, std::size_t) {
      if (!error && ++self->at_ < self->lines_.size())
        self->send_next();
      else
        self->sent(error);
    });
  }
  void leave() override {
    socket_.async_close(websocket::close_code::normal, [self = self()](error_code) {
      self->cut();
      self->advance();
    });
  }
  void close() override { beast::get_lowest_layer(socket_).close(); }
  bool reads_to_the_end() const override { return false; }  // the closing handshake does

  websocket::stream<beast::tcp_stream> socket_;
  beast::flat_buffer buffer_;
  std::vector<std::string> lines_;
  std::size_t at_ = 0;
  bool ended_ = false;
};

/// A connection that is no session yet: its first byte shows which protocol it speaks. Every method of HTTP begins with
/// a capital letter, no line of JSON does; so no page of a browser can begin a session of lines.
class Visitor : public std::enable_shared_from_this<Visitor> {
 public:
  Visitor(Hub& hub, tcp::socket socket) : hub_(hub), stream_(std::move(socket)) {}

  void begin() {
    stream_.expires_after(kFirstByte);
    stream_.async_read_some(buffer_.prepare(kBlock), [self = shared_from_this()](error_code error, std::size_t size) {
      if (error) return self->go();
      self->buffer_.commit(size);
      const char first = *static_cast<const char*>(self->buffer_.data().data());
      if (first >= 'A' && first <= 'Z')
        self->read_request();
      else
        self->become_lines();
    });
  }
  void close() { stream_.close(); }

 private:
  void go() { hub_.forget(shared_from_this()); }

  void become_lines() {
    go();
    const bool room = hub_.has_room();
    if (!room && !hub_.can_refuse()) return;
    const auto session = std::make_shared<LineSession>(hub_, std::move(stream_));
    hub_.add(session);
    const auto bytes = buffer_.data();
    if (!room) return session->refuse(hub_.full());
    session->take({static_cast<const char*>(bytes.data()), bytes.size()});
    session->begin();
  }

  void read_request() {
    parser_.header_limit(8192);
    stream_.expires_after(kRequest);
    http::async_read_header(stream_, buffer_, parser_, [self = shared_from_this()](error_code error, std::size_t) {
      if (error == http::error::header_limit)
        self->answer(http::status::request_header_fields_too_large, "The request is too long.\n");
      else if (error && error.category() == http::make_error_code(http::error::bad_method).category() &&
               error != http::error::end_of_stream)
        self->answer(http::status::bad_request, "This is neither a line of JSON nor a request of HTTP.\n");
      else if (error)
        self->go();
      else
        self->look_at_request();
    });
  }

  void look_at_request() {
    const auto& request = parser_.get();
    const std::string_view host = view(request[http::field::host]);
    const std::string_view target = view(request.target());
    if (request.count(http::field::host) != 1 || !is_own_host(host, hub_.port()))
      return answer(http::status::forbidden, "Host is no name of this server.\n");
    Manner manner = hub_.options().manner;
    if (target == kUnitWithDisplay) manner.printed.dmi = true;
    if (target == "/unit" || target == kUnitWithDisplay) return look_at_upgrade(host, manner);
    if (target != "/") return answer(http::status::not_found, "There are / and /unit.\n");
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return answer(http::status::method_not_allowed, "GET and HEAD are answered.\n");
    answer(http::status::ok, hub_.page_at_root(), "text/html; charset=utf-8");
  }

  void look_at_upgrade(std::string_view host, const Manner& manner) {
    const auto& request = parser_.get();
    if (!websocket::is_upgrade(request))
      return answer(http::status::upgrade_required, "A session is a WebSocket here, or lines over TCP.\n");
    const std::size_t origins = request.count(http::field::origin);
    if (origins > 1 || (origins == 1 && !is_own_origin(view(request[http::field::origin]), host)))
      return answer(http::status::forbidden, "Origin is another page than the one of this server.\n");
    if (!hub_.has_room()) return answer(http::status::service_unavailable, hub_.full().text() + "\n");
    go();
    const auto session = std::make_shared<WebSession>(hub_, std::move(stream_), manner);
    hub_.add(session);
    session->accept(request);
  }

  void answer(http::status status, std::string text, const char* type = "text/plain; charset=utf-8") {
    response_.result(status);
    response_.version(11);
    response_.keep_alive(false);
    response_.set(http::field::content_type, type);
    response_.set(http::field::cache_control, "no-store");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Cross-Origin-Resource-Policy", "same-origin");
    response_.set("Content-Security-Policy",
                  "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; "
                  "img-src data: blob:; connect-src 'self' ws://127.0.0.1:* ws://localhost:*; "
                  "frame-ancestors 'none'");
    if (status == http::status::method_not_allowed) response_.set(http::field::allow, "GET, HEAD");
    if (status == http::status::upgrade_required) response_.set(http::field::upgrade, "websocket");
    response_.body() = std::move(text);
    response_.prepare_payload();
    if (parser_.get().method() == http::verb::head) response_.body().clear();
    stream_.expires_after(kRequest);
    http::async_write(stream_, response_, [self = shared_from_this()](error_code, std::size_t) {
      error_code gone;
      (void)self->stream_.socket().shutdown(tcp::socket::shutdown_send, gone);
      self->go();
    });
  }

  Hub& hub_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  http::request_parser<http::empty_body> parser_;
  http::response<http::string_body> response_;
};

bool Hub::has_room() const {
  std::size_t units = 0;
  for (const auto& session : sessions_)
    if (!session->refused()) ++units;
  return units < options_.most_sessions;
}

io::Result<bool> Hub::listen() {
  error_code error = open({net::ip::address_v4::loopback(), options_.port});
  if (!error) {
    port_ = doors_.front().acceptor.local_endpoint().port();
    error = open({net::ip::address_v6::loopback(), port_});
    // A machine without IPv6, and a port that was chosen here and is only free at the other address, has one address.
    if (error != net::error::address_in_use || options_.port == 0) error = {};
  }
  if (error)
    return tl::unexpected(io::Diagnostic{"evc serve", "--port", std::to_string(options_.port) + ": " + error.message(),
                                         "a port that is free"});
  return true;
}

error_code Hub::open(const tcp::endpoint& wanted) {
  tcp::acceptor& acceptor = doors_.emplace_back(io_).acceptor;
  error_code error;
  (void)acceptor.open(wanted.protocol(), error);
  // Connections of a server that has just ended do not hinder the next one; one that listens does.
  if (!error) (void)acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error && wanted.protocol() == tcp::v6()) (void)acceptor.set_option(net::ip::v6_only(true), error);
  if (!error) (void)acceptor.bind(wanted, error);
  if (!error) (void)acceptor.listen(tcp::acceptor::max_listen_connections, error);
  if (error) doors_.pop_back();
  return error;
}

void Hub::accept(Door& door) {
  door.accepting = true;
  door.acceptor.async_accept([this, &door](error_code error, tcp::socket socket) {
    if (!door.acceptor.is_open()) return;
    door.accepting = false;
    if (error) return;  // as too many open files: the next look tries again
    if (visitors_.size() < kMostVisitors) {
      const auto visitor = std::make_shared<Visitor>(*this, std::move(socket));
      visitors_.insert(visitor);
      visitor->begin();
    }
    accept(door);
  });
}

void Hub::look() {
  if (stopped_()) return stop();
  for (Door& door : doors_)
    if (!door.accepting) accept(door);
  tick_.expires_after(kLook);
  tick_.async_wait([this](error_code) { look(); });
}

void Hub::stop() {
  error_code none;
  for (Door& door : doors_) (void)door.acceptor.close(none);
  for (const auto& visitor : std::set(visitors_)) visitor->close();
  for (const auto& session : std::set(sessions_)) {
    session->cut();
    session->advance();
  }
}

void Hub::run(const std::function<bool()>& stopped) {
  stopped_ = stopped;
  look();
  io_.run();
}

}  // namespace

struct Server::Network : Hub {
  using Hub::Hub;
};

Server::Server(std::unique_ptr<Network> network) : network_(std::move(network)) {}
Server::~Server() = default;

io::Result<std::unique_ptr<Server>> Server::open(const ServerOptions& options) {
  auto network = std::make_unique<Network>(options);
  if (const auto listening = network->listen(); !listening) return tl::unexpected(listening.error());
  return std::unique_ptr<Server>(new Server(std::move(network)));
}

std::uint16_t Server::port() const { return network_->port(); }

void Server::run(const std::function<bool()>& stopped) { network_->run(stopped); }

}  // namespace evc::serve
