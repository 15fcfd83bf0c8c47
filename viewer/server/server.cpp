// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/server.h"

#include <fmt/format.h>
#include <httplib.h>
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "boxplus/base/error.h"
#include "viewer/server/command.h"
#include "viewer/server/element_request.h"
#include "viewer/server/growing_pool.h"
#include "viewer/server/guard.h"
#include "viewer/server/page.h"

namespace boxplus::viewer {
namespace {

using namespace std::chrono_literals;
using Json = nlohmann::json;

/// Clients that are slow, or only connect, hold threads; they are cheap, because they sleep.
constexpr int kMostStreams = 16, kThreads = 256;
constexpr std::size_t kLongestCommand = 64 * 1024, kLongestFile = std::size_t{1} << 30;
/// A client that sends nothing for so long loses its connection, so that it does not keep a thread.
constexpr auto kPatience = 5s;
/// The same for a client that takes nothing. A page may need long to draw a large graph.
constexpr auto kPatienceToWrite = 30s;
/// Messages are written in pieces of this size, because httplib copies each piece.
constexpr std::size_t kPiece = std::size_t{1} << 20;
/// Between two groups of messages to a page; 30 frames per second.
constexpr auto kPause = 33ms;

class Tasks final : public httplib::TaskQueue {
 public:
  explicit Tasks(GrowingPool& pool) : pool_(pool) {}
  void enqueue(std::function<void()> job) override { pool_.enqueue(std::move(job)); }
  void shutdown() override { pool_.shutdown(); }

 private:
  GrowingPool& pool_;
};

/// Two servers must not share a port, as they would with SO_REUSEPORT.
void allow_restart(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

/// The stream of one page.
class PageStream {
 public:
  PageStream(Workspace& workspace, const std::string& token, std::atomic<int>& open)
      : reader_(workspace, Json{{"token", token}, {"version", BOXPLUS_VERSION}}.dump()), open_(open) {}
  ~PageStream() { --open_; }
  PageStream(const PageStream&) = delete;
  PageStream& operator=(const PageStream&) = delete;

  /// Waits for messages and sends them. Returns false if the page is gone.
  bool send_next(httplib::DataSink& sink) {
    if (reader_.has_ended()) {
      sink.done();
      return true;
    }
    std::vector<Message> messages = reader_.wait(1s);
    if (messages.empty()) messages.push_back(make_message(MessageKind::kHeartbeat, {}));
    for (const Message& message : messages) {
      for (std::size_t begin = 0; begin < message->size(); begin += kPiece) {
        if (!sink.write(message->data() + begin, std::min(kPiece, message->size() - begin))) return false;
      }
    }
    std::this_thread::sleep_for(kPause);
    return true;
  }

 private:
  Workspace::Reader reader_;
  std::atomic<int>& open_;
};

/// The name of a file as it is shown and as messages contain it.
std::string clean_name(std::string name) {
  constexpr std::size_t kLongest = 255;
  std::erase_if(name, [](unsigned char c) { return c < 0x20 || c == 0x7F; });
  if (name.size() > kLongest) name.resize(kLongest);
  return name.empty() ? "file" : name;
}

/// What the body of /open is.
bool opens_truth(std::string_view as) {
  if (!as.empty() && as != "graph" && as != "truth")
    throw InvalidArgument("as: expected one of graph, truth");
  return as == "truth";
}

void carry_out(const Command& command, Workspace& workspace) {
  switch (command.kind) {
    case Command::Kind::kOptimize:
      return workspace.optimize(command.settings);
    case Command::Kind::kStep:
      return workspace.step(command.settings);
    case Command::Kind::kGuess:
      return workspace.guess(command.start);
    case Command::Kind::kEdit:
      return workspace.edit(command.structure, command.edit);
    case Command::Kind::kRemoveFalseEdges:
      return workspace.remove_false_edges();
    case Command::Kind::kCovariances:
      return workspace.covariances();
    case Command::Kind::kReset:
      return workspace.reset();
    case Command::Kind::kStop:
      return workspace.stop();
  }
}

void answer(httplib::Response& response, int status, const Json& json) {
  response.status = status;
  response.set_content(json.dump(-1, ' ', false, Json::error_handler_t::replace), "application/json");
}

}  // namespace

class Server::Implementation {
 public:
  Implementation(Workspace& workspace, const ServerOptions& options)
      : workspace_(workspace), guard_(options.host, bind(options), make_token()) {
    http_.new_task_queue = [this] { return new Tasks(pool_); };
    http_.set_payload_max_length(kLongestFile);
    http_.set_read_timeout(kPatience);
    http_.set_write_timeout(kPatienceToWrite);
    // One request per connection: the body of a refused request is not read, and must not be taken for the
    // next request.
    http_.set_keep_alive_max_count(1);
    http_.set_keep_alive_timeout(1);
    http_.set_tcp_nodelay(true);
    http_.set_default_headers({{"Cache-Control", "no-store"},
                               {"X-Content-Type-Options", "nosniff"},
                               {"X-Frame-Options", "DENY"},
                               {"Cross-Origin-Resource-Policy", "same-origin"},
                               {"Referrer-Policy", "no-referrer"}});
    http_.set_pre_routing_handler(
        [this](const auto& request, auto& response) { return admit(request, response); });
    http_.set_exception_handler(
        [](const auto&, auto& response, const std::exception_ptr& error) { fail(response, error); });
    http_.Get("/", [](const auto&, auto& response) { send_page(response); });
    http_.Get("/favicon.ico", [](const auto&, auto& response) {
      response.set_content(std::string(icon_svg()), "image/svg+xml");
    });
    http_.Get("/stream", [this](const auto&, auto& response) { send_stream(response); });
    http_.Get("/pattern", [this](const auto& request, auto& response) {
      if (has_token(request, response))
        response.set_content(std::string(*workspace_.pattern()), "application/octet-stream");
    });
    http_.Get("/diagnosis", [this](const auto& request, auto& response) {
      if (has_token(request, response)) response.set_content(workspace_.diagnosis(), "application/json");
    });
    http_.Get("/graph", [this](const auto& request, auto& response) { send_graph(request, response); });
    http_.Get("/element", [this](const auto& request, auto& response) {
      if (!has_token(request, response)) return;
      const ElementRequest element = parse_element_request(request.params);
      response.set_content(workspace_.describe(element.structure, element.name), "application/json");
    });
    http_.Post("/command", [this](const auto& request, auto& response, const auto& content) {
      const std::optional<std::string> body = read_body(request, response, content, kLongestCommand);
      if (!body) return;
      carry_out(parse_command(*body), workspace_);
      answer(response, 200, {{"ok", true}});
    });
    http_.Post("/open", [this](const auto& request, auto& response, const auto& content) {
      const bool is_truth = opens_truth(request.get_param_value("as"));
      workspace_.expect_idle();  // before a long body is read
      std::optional<std::string> body = read_body(request, response, content, kLongestFile);
      if (!body) return;
      std::string name = clean_name(request.get_param_value("name"));
      if (is_truth) {
        workspace_.open_truth(std::move(name), std::move(*body));
      } else {
        workspace_.open(std::move(name), std::move(*body));
      }
      answer(response, 200, {{"ok", true}});
    });
    thread_ = std::thread([this] { http_.listen_after_bind(); });
    while (!http_.is_running()) std::this_thread::sleep_for(1ms);
  }

  ~Implementation() {
    workspace_.end();  // ends the streams
    http_.stop();
    thread_.join();
  }

  std::string url() const { return guard_.url(); }

 private:
  int bind(const ServerOptions& options) {
    http_.set_socket_options(allow_restart);
    const int wanted = options.port == 0 ? ServerOptions::kUsualPort : options.port;
    if (http_.bind_to_port(options.host, wanted)) return wanted;
    if (options.port == 0) {
      if (const int port = http_.bind_to_any_port(options.host); port > 0) return port;
    }
    throw Error(fmt::format("cannot listen at {}:{}: the address is unknown, or the port is taken",
                            options.host, wanted));
  }

  httplib::Server::HandlerResponse admit(const httplib::Request& request, httplib::Response& response) {
    if (request.has_header("Range")) {  // httplib would not check it against the size of the page
      answer(response, 416, {{"error", "parts are not served"}});
      return httplib::Server::HandlerResponse::Handled;
    }
    const std::string host = request.get_header_value("Host"), origin = request.get_header_value("Origin"),
                      type = request.get_header_value("Content-Type"),
                      header_token = request.get_header_value("X-Boxplus-Token"),
                      query_token = request.get_param_value("token"),
                      site = request.get_header_value("Sec-Fetch-Site");
    const std::optional<Refusal> refusal =
        guard_.check({request.method, request.path, host, origin, site, type, header_token, query_token});
    if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
    answer(response, refusal->status, {{"error", refusal->text}});
    return httplib::Server::HandlerResponse::Handled;
  }

  /// Reads the body of a request. If it is longer than `longest`, or ends too early, answers with an error
  /// and returns nothing.
  static std::optional<std::string> read_body(const httplib::Request& request, httplib::Response& response,
                                              const httplib::ContentReader& content, std::size_t longest) {
    std::string body;
    bool fits = !request.is_multipart_form_data(), is_complete = false;
    if (fits) {
      is_complete = content([&](const char* data, std::size_t size) {
        fits = fits && size <= longest - body.size();
        if (fits) body.append(data, size);
        return fits;
      });
    }
    if (fits && is_complete) return body;
    if (fits) {
      answer(response, 400, {{"error", "the request is not complete"}});
    } else {
      answer(response, 413, {{"error", "the request is too long"}});
    }
    return std::nullopt;
  }

  /// For requests with GET that need the token. Answers with an error if it is missing.
  bool has_token(const httplib::Request& request, httplib::Response& response) const {
    if (request.get_header_value("X-Boxplus-Token") == guard_.token()) return true;
    answer(response, 403, {{"error", "the token is missing or wrong"}});
    return false;
  }

  void send_graph(const httplib::Request& request, httplib::Response& response) {
    if (!has_token(request, response)) return;
    response.set_content(workspace_.formatted(request.get_param_value("format")), "application/octet-stream");
  }

  static void fail(httplib::Response& response, const std::exception_ptr& error) {
    try {
      std::rethrow_exception(error);
    } catch (const Busy& busy) {
      answer(response, 409, {{"error", busy.what()}});
    } catch (const InvalidArgument& refused) {
      answer(response, 400, {{"error", refused.what()}});
    } catch (...) {
      answer(response, 500, {{"error", "the server failed"}});
    }
  }

  static void send_page(httplib::Response& response) {
    const std::string_view page = page_html_gz();
    response.set_header("Content-Encoding", "gzip");
    // A content provider with a length is sent as it is, not compressed again.
    response.set_content_provider(page.size(), "text/html; charset=utf-8",
                                  [page](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                    const std::string_view part =
                                        page.substr(std::min(offset, page.size()), length);
                                    return sink.write(part.data(), part.size());
                                  });
  }

  void send_stream(httplib::Response& response) {
    if (++streams_ > kMostStreams) {
      --streams_;
      answer(response, 503, {{"error", fmt::format("{} pages are open already", kMostStreams)}});
      return;
    }
    auto stream = std::make_shared<PageStream>(workspace_, guard_.token(), streams_);
    response.set_chunked_content_provider("application/octet-stream",
                                          [stream](std::size_t, httplib::DataSink& sink) {
                                            try {
                                              return stream->send_next(sink);
                                            } catch (...) {  // httplib would let it end the process
                                              return false;
                                            }
                                          });
  }

  Workspace& workspace_;
  GrowingPool pool_{kThreads};
  httplib::Server http_;
  Guard guard_;
  std::atomic<int> streams_ = 0;
  std::thread thread_;
};

Server::Server(Workspace& workspace, const ServerOptions& options)
    : implementation_(std::make_unique<Implementation>(workspace, options)) {}

Server::~Server() = default;

std::string Server::url() const {
  return implementation_->url();
}

}  // namespace boxplus::viewer
