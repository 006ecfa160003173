// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/server.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <cerrno>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "hardball/errors/error.hpp"
#include "support/scratch_folder.hpp"
#include "unit/viewer/small_run.hpp"

namespace hardball::viewer::server_test {
namespace {

using nlohmann::json;
using namespace support;

// A bare connection to a port of this machine, for clients that do not behave.
class Connection {
 public:
  explicit Connection(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
  }
  ~Connection() { close(socket_); }
  Connection(const Connection&) = delete;

  void say(const std::string& text) const {
    EXPECT_EQ(::send(socket_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }
  int descriptor() const { return socket_; }
  /// Closes the sending side.
  void fall_silent() const { shutdown(socket_, SHUT_WR); }
  /// The next bytes, at most `most`; empty at the end.
  std::string hear(std::size_t most) const {
    std::string text(most, '\0');
    const ssize_t got = recv(socket_, text.data(), most, 0);
    text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return text;
  }
  /// Whether the other side neither has said anything nor has closed.
  bool is_waiting() const {
    char next = 0;
    return recv(socket_, &next, 1, MSG_PEEK | MSG_DONTWAIT) < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
  }
  /// How often its packets had to be sent again, among them those that open it.
  unsigned repetitions() const {
    tcp_info info{};
    socklen_t length = sizeof(info);
    EXPECT_EQ(getsockopt(socket_, IPPROTO_TCP, TCP_INFO, &info, &length), 0);
    return info.tcpi_total_retrans;
  }
  /// All up to the end.
  std::string hear_all() const {
    std::string all;
    for (std::string part = hear(1 << 16); !part.empty(); part = hear(1 << 16)) all += part;
    return all;
  }

 private:
  int socket_;
};

// A finished recording being served.
class ServerTest : public testing::Test {
 protected:
  ServerTest() {
    record(folder_ / "recording.hbr", make_gas({.count = 100, .packing_fraction = 0.2}), 20);
    recording_.emplace(folder_ / "recording.hbr");
    recording_->update(
        {.is_finished = true, .failure = {}, .collisions = 7, .walls = 2, .rate = 0.5, .hash = 0x00ab});
    server_.emplace(*recording_, kSmallPage);
  }

  httplib::Client client() const { return httplib::Client("127.0.0.1", server_->port()); }
  std::string with_token(const std::string& path) const {
    return path + (path.find('?') == std::string::npos ? "?" : "&") + "token=" + server_->token();
  }
  httplib::Result get(const std::string& path) const { return client().Get(with_token(path)); }
  std::string host() const { return "127.0.0.1:" + std::to_string(server_->port()); }
  std::string raw_answer(const std::string& request) const {
    const Connection connection(server_->port());
    connection.say(request);
    return connection.hear_all();
  }

  ScratchFolder folder_;
  std::optional<SharedRecording> recording_;
  std::optional<Server> server_;
};

TEST_F(ServerTest, PrintsAnAddressThatOpensThePage) {
  EXPECT_EQ(server_->url(), "http://" + host() + "/?token=" + server_->token());
  const auto index = get("/");
  ASSERT_TRUE(index);
  EXPECT_EQ(index->status, 200);
  EXPECT_EQ(index->get_header_value("Content-Type"), "text/html; charset=utf-8");
  const std::string address = "page.js?token=" + server_->token();
  EXPECT_NE(index->body.find(address), std::string::npos) << index->body;
  const auto script = client().Get("/" + address);
  EXPECT_EQ(script->body, kSmallPage.script);
  EXPECT_EQ(script->get_header_value("Content-Type"), "text/javascript; charset=utf-8");
  const auto style = get("/page.css");
  EXPECT_EQ(style->body, kSmallPage.style);
  EXPECT_EQ(style->get_header_value("Content-Type"), "text/css; charset=utf-8");
}

TEST_F(ServerTest, GivesTheHeader) {
  const json header = json::parse(get("/api/header")->body);
  EXPECT_EQ(header["spheres"], 100);
  EXPECT_EQ(header["name"], "gas");
  EXPECT_EQ(header["until"], 20);
  EXPECT_EQ(header["chunks"], RecordingReader(folder_ / "recording.hbr").chunks().size());
}

TEST_F(ServerTest, GivesRadiiAndMasses) {
  const std::string bytes = get("/api/spheres")->body;
  ASSERT_EQ(bytes.size(), 1600U);
  EXPECT_EQ(read_little_endian<double>(bytes.data()), 0.5);
  EXPECT_EQ(read_little_endian<double>(bytes.data() + 800), 1);
}

TEST_F(ServerTest, GivesTheStatus) {
  const json status = json::parse(get("/api/status")->body);
  const RecordingReader reader(folder_ / "recording.hbr");
  EXPECT_EQ(status["chunks"], reader.chunks().size());
  EXPECT_EQ(status["chunk_ends"].size(), reader.chunks().size());
  EXPECT_EQ(status["chunk_ends"][0], reader.chunks()[0].end);
  EXPECT_EQ(status["begin"], 0);
  EXPECT_EQ(status["until"], 20);
  EXPECT_EQ(status["reached"], 20);
  EXPECT_EQ(status["finished"], true);
  EXPECT_TRUE(status["failed"].is_null());
  EXPECT_EQ(status["spheres"], 100);
  EXPECT_EQ(status["collisions"], 7);
  EXPECT_EQ(status["walls"], 2);
  EXPECT_EQ(status["rate"], 0.5);
  EXPECT_EQ(status["event_log_hash"], "00000000000000ab");
  EXPECT_TRUE(status["divisions"].empty()) << "a recording has no domains";
  const json rest = json::parse(get("/api/status?from=1")->body)["chunk_ends"];
  EXPECT_EQ(rest.size() + 1, reader.chunks().size());
  EXPECT_EQ(json::parse(get("/api/status?from=99999999999")->body)["chunk_ends"].size(), 0U);
}

TEST_F(ServerTest, GivesEveryChunkAsInTheFile) {
  const RecordingReader reader(folder_ / "recording.hbr");
  const std::string file = read_text(folder_ / "recording.hbr");
  ASSERT_GT(reader.chunks().size(), 1U);
  for (std::size_t k = 0; k < reader.chunks().size(); ++k) {
    const FileExtent& extent = reader.chunks()[k].bytes;
    const auto chunk = get("/api/chunk?number=" + std::to_string(k));
    EXPECT_EQ(chunk->get_header_value("Content-Type"), "application/octet-stream");
    EXPECT_TRUE(chunk->body == file.substr(extent.offset, extent.length)) << k;
  }
}

TEST_F(ServerTest, GivesTheRangesOfBytesThatThereAre) {
  const std::string whole = get("/api/spheres")->body;
  const std::size_t length = whole.size();
  ASSERT_EQ(length, 1600U);
  const auto ask = [&](const std::string& path, const std::string& range) {
    const auto answer = client().Get(with_token(path), {{"Range", "bytes=" + range}});
    EXPECT_TRUE(answer) << range;
    return answer ? *answer : httplib::Response();
  };
  const auto expect_part = [&](const std::string& range, std::size_t first, std::size_t count) {
    const httplib::Response answer = ask("/api/spheres", range);
    EXPECT_EQ(answer.status, 206) << range;
    EXPECT_TRUE(answer.body == whole.substr(first, count)) << range;
    EXPECT_EQ(answer.get_header_value("Content-Range"),
              "bytes " + std::to_string(first) + "-" + std::to_string(first + count - 1) + "/1600");
  };
  expect_part("0-9", 0, 10);
  expect_part("1000-", 1000, 600);
  expect_part("-5", 1595, 5);
  expect_part("1599-1599", 1599, 1);
  expect_part("1590-99999999", 1590, 10);
  expect_part("-99999999", 0, 1600);
  for (const std::string path : {"/api/spheres", "/page.css", "/", "/api/header", "/api/replay.html"}) {
    for (const std::string range : {"99999999-", "99999999-99999999999", "-0", "99999999-,88888888-"}) {
      const httplib::Response answer = ask(path, range);
      EXPECT_EQ(answer.status, 416) << path << " " << range;
      EXPECT_TRUE(answer.get_header_value("Content-Range").starts_with("bytes */")) << path;
    }
  }
  // One of them there is, the other there is not; and so many that nobody needs them.
  EXPECT_EQ(ask("/api/spheres", "0-9,99999999-").body, whole.substr(0, 10));
  std::string crumbs = "0-0";
  for (int i = 1; i < 100; ++i) crumbs += "," + std::to_string(i) + "-" + std::to_string(i);
  EXPECT_TRUE(ask("/api/spheres", crumbs).body == whole);
  for (const std::string nonsense : {"5-2", "abc", "", "-", "1-2-3"}) {
    const auto answer = client().Get(with_token("/api/spheres"), {{"Range", "bytes=" + nonsense}});
    EXPECT_TRUE(answer) << nonsense;
  }
  EXPECT_TRUE(get("/api/spheres")->body == whole) << "and the server continues";
}

TEST_F(ServerTest, GivesTheReplayToSave) {
  const auto replay = get("/api/replay.html");
  EXPECT_EQ(replay->status, 200);
  EXPECT_EQ(replay->get_header_value("Content-Disposition"), "attachment; filename=\"gas.html\"");
  const OnePiece page(kSmallPage);
  EXPECT_TRUE(replay->body.starts_with(page.head));
  EXPECT_TRUE(replay->body.ends_with(page.tail));
  EXPECT_GT(replay->body.size(), std::filesystem::file_size(folder_ / "recording.hbr"));
}

TEST_F(ServerTest, RefusesTheReplayOfALongRecording) {
  make_huge_recording(folder_ / "huge.hbr");
  const SharedRecording huge(folder_ / "huge.hbr");
  const Server server(huge, kSmallPage);
  httplib::Client client("127.0.0.1", server.port());
  const auto replay = client.Get("/api/replay.html?token=" + server.token());
  EXPECT_EQ(replay->status, 413);
  EXPECT_NE(replay->body.find("a replay holds at most 200000000"), std::string::npos) << replay->body;
}

TEST_F(ServerTest, ServesARecordingWithoutSpheres) {
  RecordingWriter(folder_ / "empty.hbr", {}, World()).close(0);
  const SharedRecording empty(folder_ / "empty.hbr");
  const Server server(empty, kSmallPage);
  httplib::Client client("127.0.0.1", server.port());
  const auto spheres = client.Get("/api/spheres?token=" + server.token());
  EXPECT_EQ(spheres->status, 200);
  EXPECT_EQ(spheres->body, "");
}

TEST_F(ServerTest, AnswersOnlyWithTheToken) {
  std::string wrong = server_->token();
  wrong.back() = wrong.back() == '0' ? '1' : '0';
  for (const std::string path : {"/", "/page.js", "/page.css", "/api/header", "/api/spheres", "/api/status",
                                 "/api/chunk", "/api/replay.html", "/nowhere"}) {
    for (const std::string& query :
         {std::string(), std::string("?token="), "?token=" + wrong, "?token=" + server_->token() + "0",
          "?Token=" + server_->token(), "?token=" + server_->token().substr(1)}) {
      const auto answer = client().Get(path + query);
      ASSERT_TRUE(answer);
      EXPECT_EQ(answer->status, 403) << path << query;
      EXPECT_EQ(answer->body.find(server_->token()), std::string::npos);
    }
  }
  EXPECT_EQ(get("/api/header")->status, 200);
}

TEST_F(ServerTest, AnswersOnlyToItsOwnName) {
  const std::string port = std::to_string(server_->port());
  for (const std::string& name : {std::string("evil.example"), "evil.example:" + port,
                                  std::string("127.0.0.1"), std::string("localhost"), "127.0.0.1:1" + port,
                                  "127.0.0.2:" + port, "127.0.0.1:" + port + ".evil.example"}) {
    const auto answer = client().Get(with_token("/api/header"), {{"Host", name}});
    EXPECT_EQ(answer->status, 403) << name;
  }
  EXPECT_EQ(client().Get(with_token("/api/header"), {{"Host", "localhost:" + port}})->status, 200);
  const std::string nameless = raw_answer("GET " + with_token("/api/header") + " HTTP/1.0\r\n\r\n");
  EXPECT_TRUE(nameless.starts_with("HTTP/1.1 403 ")) << nameless;
}

TEST_F(ServerTest, SetsSecurityHeaders) {
  for (const auto& answer : {get("/"), get("/api/status"), get("/nowhere"), client().Get("/")}) {
    EXPECT_EQ(answer->get_header_value("Cache-Control"), "no-store");
    EXPECT_EQ(answer->get_header_value("X-Content-Type-Options"), "nosniff");
    EXPECT_EQ(answer->get_header_value("Referrer-Policy"), "no-referrer");
    const std::string policy = answer->get_header_value("Content-Security-Policy");
    EXPECT_TRUE(policy.starts_with("default-src 'self';")) << policy;
    EXPECT_NE(policy.find("frame-ancestors 'none'"), std::string::npos) << policy;
    EXPECT_FALSE(answer->has_header("Access-Control-Allow-Origin"));
    EXPECT_FALSE(answer->has_header("Set-Cookie"));
  }
}

TEST_F(ServerTest, ChangesNothing) {
  for (const std::string method : {"POST", "PUT", "DELETE", "PATCH", "OPTIONS"}) {
    const std::string answer =
        raw_answer(method + " " + with_token("/api/status") + " HTTP/1.1\r\nHost: " + host() +
                   "\r\nContent-Length: 0\r\nConnection: close\r\n\r\n");
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 405 ")) << method << answer;
  }
}

TEST_F(ServerTest, ReadsNoFileThatARequestNames) {
  write_text(folder_ / "secret.txt", "the secret");
  const std::string up = "../../../../../../../../../..";
  for (const std::string& path :
       {up + "/etc/passwd", "/" + up + "/etc/passwd", "/api/" + up + "/etc/passwd",
        std::string("/%2e%2e/%2e%2e/%2e%2e/%2e%2e/etc/passwd"),
        std::string("/..%2f..%2f..%2f..%2fetc/passwd"), std::string("//etc/passwd"),
        std::string("/page.js/../../etc/passwd"), std::string("/pageXjs"), std::string("file:///etc/passwd"),
        (folder_ / "secret.txt").string(), std::string("/recording.hbr"), std::string("/api/chunk/0")}) {
    const std::string answer = raw_answer("GET " + with_token(path) + " HTTP/1.1\r\nHost: " + host() +
                                          "\r\nConnection: close\r\n\r\n");
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 404 ") || answer.starts_with("HTTP/1.1 400 ")) << path << answer;
    EXPECT_EQ(answer.find("root:"), std::string::npos);
    EXPECT_EQ(answer.find("the secret"), std::string::npos);
  }
}

TEST_F(ServerTest, RefusesInvalidQueries) {
  for (const std::string path : {"/api/chunk", "/api/chunk?number=", "/api/chunk?number=-1",
                                 "/api/chunk?number=x", "/api/chunk?number=1.5", "/api/chunk?number=1x",
                                 "/api/chunk?number=%201", "/api/chunk?number=18446744073709551616",
                                 "/api/status?from=", "/api/status?from=-1", "/api/status?from=nan"}) {
    EXPECT_EQ(get(path)->status, 400) << path;
  }
  for (const std::string path : {"/api/chunk?number=1000", "/api/chunk?number=18446744073709551615"}) {
    EXPECT_EQ(get(path)->status, 404) << path;
  }
}

TEST_F(ServerTest, SurvivesInvalidRequests) {
  const std::vector<std::string> nonsense{"\r\n\r\n",
                                          "GET\r\n\r\n",
                                          "GET / HTTP/9.9\r\n\r\n",
                                          std::string(100, '\0') + "\r\n\r\n",
                                          "GET /" + std::string(20'000, 'a') + " HTTP/1.1\r\n\r\n",
                                          "GET / HTTP/1.1\r\nX: " + std::string(20'000, 'a') + "\r\n\r\n"};
  for (const std::string& request : nonsense) {
    const Connection connection(server_->port());
    connection.say(request);
    connection.fall_silent();
    connection.hear_all();
  }
  EXPECT_EQ(get("/api/status")->status, 200);
}

// They are held until the end of the test.
TEST_F(ServerTest, AnswersBesideManyUnfinishedRequests) {
  constexpr std::chrono::seconds kPatience(100);
  const Server server(*recording_, kSmallPage, 0, {.patience = kPatience});
  std::vector<std::unique_ptr<Connection>> unfinished;
  for (int i = 0; i < 200; ++i) {
    unfinished.push_back(std::make_unique<Connection>(server.port()));
    unfinished.back()->say("GET / HTTP/1.1\r\n");
  }
  httplib::Client client("127.0.0.1", server.port());
  client.set_read_timeout(kPatience);
  const auto answer = client.Get("/?token=" + server.token());
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  for (const auto& connection : unfinished) {
    ASSERT_TRUE(connection->is_waiting());
    ASSERT_EQ(connection->repetitions(), 0U) << "which takes a second";
  }
}

// The patience of a server that waits only for these tests.
constexpr ClientLimits kImpatient{.patience = std::chrono::milliseconds(300)};

TEST_F(ServerTest, EndsAHeadThatTakesTooLong) {
  server_.emplace(*recording_, kSmallPage, 0, kImpatient);
  const Connection connection(server_->port());
  std::atomic<bool> has_ended = false;
  std::thread trickle([&] {
    for (int i = 0; i < 600 && !has_ended; ++i) {
      // Each byte comes in time; all of them do not.
      if (::send(connection.descriptor(), "G", 1, MSG_NOSIGNAL) < 0) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    has_ended = true;
  });
  EXPECT_EQ(connection.hear_all(), "");
  EXPECT_FALSE(has_ended.exchange(true)) << "the client gave up, and not the server";
  trickle.join();
}

TEST_F(ServerTest, EndsAHeadThatIsTooLong) {
  const Connection connection(server_->port());
  const std::string line = "X: " + std::string(1000, 'x') + "\r\n";
  std::string head = "GET / HTTP/1.1\r\n";
  while (head.size() <= ClientLimits().head_bytes) head += line;
  connection.say(head);
  EXPECT_TRUE(connection.hear_all().starts_with("HTTP/1.1 431 "));
}

TEST_F(ServerTest, LetsTheOwnerInBesideManyStrangers) {
  server_.emplace(*recording_, kSmallPage, 0,
                  ClientLimits{.patience = std::chrono::hours(1), .strangers = 20});
  std::vector<std::unique_ptr<Connection>> strangers;
  for (int i = 0; i < 600; ++i) {
    strangers.push_back(std::make_unique<Connection>(server_->port()));
    strangers.back()->say("G");
  }
  const auto answer = get("/api/header");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  const auto waiting = [&] {
    return std::ranges::count_if(strangers, [](const auto& stranger) { return stranger->is_waiting(); });
  };
  for (int i = 0; i < 60'000 && waiting() > 20; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_LE(waiting(), 20) << "those that came first give way";
  EXPECT_GT(waiting(), 0);
}

TEST_F(ServerTest, EndsWithAllConnections) {
  server_.emplace(*recording_, kSmallPage, 0, ClientLimits{.patience = std::chrono::hours(1)});
  const Connection silent(server_->port());
  const Connection unfinished(server_->port());
  unfinished.say("GET / HTTP/1.1\r\nHost: ");
  ASSERT_TRUE(get("/api/header"));
  server_.reset();
  EXPECT_EQ(silent.hear_all(), "");
}

TEST_F(ServerTest, UsesTheGivenPort) {
  const int taken = server_->port();
  EXPECT_THROW(Server(*recording_, kSmallPage, taken), Error);
  server_.reset();
  const Server again(*recording_, kSmallPage, taken);
  EXPECT_EQ(again.port(), taken);
}

TEST_F(ServerTest, ListensAtThisMachineAlone) {
  const int listener = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(server_->port()));
  // Another address of the loopback: a server at all addresses would answer here.
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK + 1);
  EXPECT_NE(connect(listener, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
  close(listener);
}

// Twenty clients download a replay from a live run, and none continues before all have started. Meanwhile
// twenty connections send nothing, five clients vanish during their download and five read nothing. Neither
// the twenty nor the run may be held up.
TEST(ServerOfALiveRun, ServesManyClientsAndDoesNotHoldUpTheRun) {
  constexpr int kClients = 20;
  constexpr std::uint64_t kFurther = 20'000;
  // More than systems buffer for a client that does not read.
  constexpr std::uint64_t kLongReplay = 5'000'000;
  const ScratchFolder folder;
  const SmallRun run(folder / "live.hbr", make_gas({.count = 10'000, .packing_fraction = 0.2}), 1e9,
                     50'000'000);
  constexpr std::chrono::seconds kPatience(30);
  const Server server(run.recording(), kSmallPage, 0, {.patience = kPatience});
  while (run.recording().length() < kLongReplay) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const std::string request = "GET /api/replay.html?token=" + server.token() +
                              " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server.port()) +
                              "\r\nConnection: close\r\n\r\n";
  std::vector<std::unique_ptr<Connection>> idle;
  for (int k = 0; k < kClients; ++k) idle.push_back(std::make_unique<Connection>(server.port()));
  std::vector<std::unique_ptr<Connection>> deaf;
  for (int k = 0; k < 5; ++k) {
    deaf.push_back(std::make_unique<Connection>(server.port()));
    deaf.back()->say(request);
  }
  for (int k = 0; k < 5; ++k) {
    const Connection vanishing(server.port());
    vanishing.say(request);
    EXPECT_EQ(vanishing.hear(100).size(), 100U);
  }
  const auto contacts = [&run] {
    const RunProgress progress = run.recording().progress();
    return progress.collisions + progress.walls;
  };
  const std::uint64_t contacts_before = contacts();
  std::barrier all_have_begun(kClients);
  std::atomic<int> served = 0;
  std::vector<std::thread> crowd;
  for (int k = 0; k < kClients; ++k) {
    crowd.emplace_back([&] {
      const Connection connection(server.port());
      connection.say(request);
      std::string answer = connection.hear(100);
      all_have_begun.arrive_and_wait();
      answer += connection.hear_all();
      const bool is_whole = answer.size() > kLongReplay && answer.ends_with(OnePiece(kSmallPage).tail);
      if (is_whole) ++served;
    });
  }
  for (std::thread& client : crowd) client.join();
  EXPECT_EQ(served, kClients);
  while (contacts() < contacts_before + kFurther && !run.recording().progress().is_finished) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  // A run that has meanwhile reached the limit of its recording has not been held up, either.
  EXPECT_TRUE(contacts() >= contacts_before + kFurther || run.recording().progress().is_finished);
}

}  // namespace
}  // namespace hardball::viewer::server_test
