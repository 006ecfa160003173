// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/server.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "apps/viewer/connection_threads.hpp"
#include "apps/viewer/film.hpp"
#include "apps/viewer/guarded_server.hpp"
#include "apps/viewer/http.hpp"
#include "apps/viewer/replay.hpp"
#include "apps/viewer/token.hpp"
#include "hardball/errors/error.hpp"

namespace hardball::viewer {
namespace {

using httplib::Request;
using httplib::Response;

constexpr const char* kHost = "127.0.0.1";

// Fewer than the files that a process may usually open.
constexpr std::size_t kMaxConnections = 512;

constexpr std::string_view kTokenKey = "token=";

constexpr std::size_t kPieceBytes = 1 << 16;

// What the page sends of a film at a time.
constexpr std::size_t kMaxPieceBytes = 1 << 28;

constexpr const char* kFilmPath = "/api/film";

constexpr int kBadRequest = 400;
constexpr int kForbidden = 403;
constexpr int kNotFound = 404;
constexpr int kMethodNotAllowed = 405;
constexpr int kTooLarge = 413;
constexpr int kRangeNotSatisfiable = 416;
constexpr int kServerError = 500;

void refuse(Response& response, int status, const std::string& reason) {
  response.status = status;
  response.set_content(reason + "\n", "text/plain; charset=utf-8");
}

// Clips the byte ranges of a request to the content; false if none of them overlaps it. httplib itself would
// request pieces beyond the end. Source: RFC 9110, section 14.1.2.
bool clip_ranges(const Request& request, std::uint64_t length) {
  // httplib reads the ranges from the request when it sends.
  httplib::Ranges& ranges = const_cast<Request&>(request).ranges;
  if (ranges.empty()) return true;
  const auto end = static_cast<ssize_t>(length);
  for (auto& [first, last] : ranges) {
    if (first < 0) {  // the last bytes, as many as `last` says
      first = last > 0 ? std::max<ssize_t>(end - last, 0) : end;
      last = end - 1;
    }
    if (last < 0 || last >= end) last = end - 1;
  }
  std::erase_if(ranges, [](const httplib::Range& range) { return range.first > range.second; });
  // A request for many small ranges is answered with the whole content.
  constexpr std::size_t kMaxRanges = 8;
  const bool is_satisfiable = !ranges.empty();
  if (ranges.size() > kMaxRanges) ranges.clear();
  return is_satisfiable;
}

// Sends `length` bytes, of which piece(offset) returns some from an offset on. Such content is not
// compressed, which would take longer than sending it locally.
void send(const Request& request, Response& response, std::uint64_t length, const std::string& type,
          std::function<std::string(std::uint64_t offset)> piece) {
  if (!clip_ranges(request, length)) {
    response.set_header("Content-Range", "bytes */" + to_text(length));
    return refuse(response, kRangeNotSatisfiable, "there are " + to_text(length) + " bytes here");
  }
  if (length == 0) {
    response.set_content("", type);
    return;
  }
  const auto provide = [piece = std::move(piece)](std::size_t offset, std::size_t most,
                                                  httplib::DataSink& sink) {
    try {
      const std::string bytes = piece(offset);
      return sink.write(bytes.data(), std::min(bytes.size(), most));
    } catch (const RunFailure&) {
      return false;
    }
  };
  response.set_content_provider(length, type.c_str(), provide);
}

void send(const Request& request, Response& response, std::string text, const std::string& type) {
  const std::size_t length = text.size();
  send(request, response, length, type,
       [text = std::move(text)](std::uint64_t offset) { return text.substr(offset, kPieceBytes); });
}

void send(const Request& request, Response& response, const SharedRecording& recording,
          const FileExtent& extent) {
  send(request, response, extent.length, "application/octet-stream",
       [&recording, extent](std::uint64_t offset) {
         return recording.read(
             {extent.offset + offset, std::min<std::uint64_t>(kPieceBytes, extent.length - offset)});
       });
}

// The number given by a query, or a default without one; none if it is not a number.
std::optional<std::uint64_t> number_in(const Request& request, const std::string& key,
                                       std::optional<std::uint64_t> otherwise = {}) {
  if (!request.has_param(key)) return otherwise;
  const std::string text = request.get_param_value(key);
  std::uint64_t number = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (status != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// The file name under which a browser saves a replay: characters safe in headers and on all systems.
std::string file_name(const RecordingHeader& header) {
  std::string name = header.name.substr(0, 64);
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  };
  std::replace_if(name.begin(), name.end(), std::not_fn(is_plain), '_');
  return (name.empty() ? "recording" : name) + ".html";
}

}  // namespace

Server::Server(const SharedRecording& recording, const Page& page, int port, const ClientLimits& limits,
               Film* film)
    : recording_(&recording),
      film_(film),
      page_(page),
      token_(make_token()),
      index_(with_token(page, token_)),
      server_(std::make_unique<GuardedServer>(limits, [this](std::string_view line) {
        const std::size_t begin = line.find(kTokenKey);
        return begin != std::string_view::npos &&
               is_same_secret(line.substr(begin + kTokenKey.size(), token_.size()), token_);
      })) {
  set_rules();
  add_page();
  add_recording();
  if (film_) add_film();
  if (port == 0) {
    port_ = server_->bind_to_any_port(kHost);
    if (port_ <= 0) throw Error("no port is free", "viewer", "close other programs");
  } else {
    if (!server_->bind_to_port(kHost, port)) {
      throw Error("port " + to_text(port) + " is taken or not allowed", "--port",
                  "choose another one, or none to use any free one");
    }
    port_ = port;
  }
  // The library lets five wait, and a connection that finds no room is tried again only after a second.
  listen(socket_, static_cast<int>(kMaxConnections));
  thread_ = std::thread([this] { server_->listen_after_bind(); });
  // It cannot be stopped before it runs.
  while (!server_->is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

Server::~Server() {
  server_->end_connections();
  server_->stop();
  thread_.join();
}

std::string Server::url() const {
  return "http://" + std::string(kHost) + ":" + to_text(port_) + "/?token=" + token_;
}

void Server::set_rules() {
  server_->new_task_queue = [] { return new ConnectionThreads(kMaxConnections); };
  server_->set_payload_max_length(film_ ? kMaxPieceBytes : 0);
  server_->set_socket_options([this](socket_t socket) {
    socket_ = socket;
    platform::keep_port(socket);
  });
  server_->set_default_headers({
      {"Cache-Control", "no-store"},
      {"Content-Security-Policy",
       "default-src 'self'; img-src 'self' data: blob:; base-uri 'none'; form-action 'none'; "
       "frame-ancestors 'none'"},
      {"Cross-Origin-Opener-Policy", "same-origin"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
      {"Referrer-Policy", "no-referrer"},
      {"X-Content-Type-Options", "nosniff"},
  });
  server_->set_pre_routing_handler([this](const Request& request, Response& response) {
    return is_allowed(request, response) ? httplib::Server::HandlerResponse::Unhandled
                                         : httplib::Server::HandlerResponse::Handled;
  });
  server_->set_exception_handler([](const Request&, Response& response, const std::exception_ptr&) {
    refuse(response, kServerError, "the request could not be answered");
  });
  server_->set_error_handler([](const Request&, Response& response) {
    if (response.body.empty() && response.status == kNotFound) {
      refuse(response, kNotFound, "there is nothing here");
    }
  });
}

bool Server::is_allowed(const Request& request, Response& response) const {
  // Against DNS rebinding: a foreign page may resolve its own name to this machine, but sends that name.
  const std::string host = request.get_header_value("Host");
  const std::string port = ":" + to_text(port_);
  if (host != kHost + port && host != "localhost" + port) {
    refuse(response, kForbidden, "this server does not have that name");
    return false;
  }
  if (!is_same_secret(request.get_param_value("token"), token_)) {
    refuse(response, kForbidden,
           "the token is missing or wrong: open the address that hardball view printed");
    return false;
  }
  const bool is_of_film = film_ && request.method == "POST" && request.path == kFilmPath;
  if (request.method != "GET" && request.method != "HEAD" && !is_of_film) {
    response.set_header("Allow", "GET, HEAD");
    refuse(response, kMethodNotAllowed, "there is nothing to change here");
    return false;
  }
  return true;
}

void Server::add_page() {
  server_->Get("/", [this](const Request& request, Response& response) {
    send(request, response, index_, "text/html; charset=utf-8");
  });
  server_->Get("/page\\.css", [this](const Request& request, Response& response) {
    send(request, response, std::string(page_.style), "text/css; charset=utf-8");
  });
  server_->Get("/page\\.js", [this](const Request& request, Response& response) {
    send(request, response, std::string(page_.script), "text/javascript; charset=utf-8");
  });
  server_->Get("/api/replay\\.html", [this](const Request& request, Response& response) {
    try {
      const auto replay = std::make_shared<const Replay>(*recording_, page_);
      // For saving: this server's Content-Security-Policy would not let it run.
      response.set_header("Content-Disposition",
                          "attachment; filename=\"" + file_name(recording_->header()) + "\"");
      send(request, response, replay->length(), "text/html; charset=utf-8",
           [replay](std::uint64_t offset) { return replay->piece(offset); });
    } catch (const Error& error) {
      refuse(response, kTooLarge, error.what());
    }
  });
}

void Server::add_recording() {
  server_->Get("/api/header", [this](const Request& request, Response& response) {
    send(request, response, recording_->header_json(), "application/json");
  });
  server_->Get("/api/spheres", [this](const Request& request, Response& response) {
    send(request, response, *recording_, recording_->spheres());
  });
  server_->Get("/api/status", [this](const Request& request, Response& response) {
    const std::optional<std::uint64_t> from = number_in(request, "from", 0);
    if (!from) return refuse(response, kBadRequest, "'from' is not a chunk number");
    send(request, response, recording_->status_json(*from), "application/json");
  });
  server_->Get("/api/chunk", [this](const Request& request, Response& response) {
    const std::optional<std::uint64_t> number = number_in(request, "number");
    if (!number) return refuse(response, kBadRequest, "'number' is missing or not a chunk number");
    const std::optional<FileExtent> chunk = recording_->chunk(*number);
    if (!chunk) return refuse(response, kNotFound, "there is no such chunk yet");
    send(request, response, *recording_, *chunk);
  });
}

void Server::add_film() {
  server_->Get(kFilmPath, [this](const Request& request, Response& response) {
    send(request, response, film_->order_json(), "application/json");
  });
  server_->Post(kFilmPath, [this](const Request& request, Response& response) {
    const auto number = [&](const std::string& key) { return number_in(request, key); };
    try {
      if (const auto position = number("position")) {
        film_->write(*position, request.body);
      } else if (const auto frame = number("frame")) {
        film_->write_frame(*frame, request.body);
      } else if (const auto shown = number("shown")) {
        film_->note(*shown, number("of").value_or(0));
      } else if (const auto count = number("ended")) {
        film_->note(*count, *count);
        film_->end(std::nullopt);
      } else if (request.has_param("failed")) {
        film_->end(request.get_param_value("failed"));
      } else {
        return refuse(response, kBadRequest, "the query says nothing of a film");
      }
      response.set_content("", "text/plain; charset=utf-8");
    } catch (const std::exception& error) {
      film_->end(error.what());
      refuse(response, kServerError, error.what());
    }
  });
}

}  // namespace hardball::viewer
