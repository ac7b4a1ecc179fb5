// SPDX-License-Identifier: Apache-2.0
// A listening socket of another owner, as systemd has it: it outlives each server that uses it.
#include "host/web/inherited_socket.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <future>

#include "tests/host/web_fixture.hpp"

namespace {

using web::InheritedSocket;

class Owner : public host_test::SpoolerTest {
 protected:
  Owner() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    bind(own, reinterpret_cast<sockaddr*>(&address), sizeof address);
    listen(own, 16);
  }
  ~Owner() override { close(own); }

  // What a process started by the owner has.
  std::unique_ptr<web::Server> made_server() {
    const int theirs = dup(own);
    const InheritedSocket socket = web::inherited_socket_at(theirs);
    port = socket.address.port;
    return std::make_unique<web::Server>(spool(), web::Address{}, web::Rules{}, web::WaitLimits{},
                                         socket);
  }
  int status() const {
    httplib::Client client("127.0.0.1", port);
    client.set_read_timeout(std::chrono::seconds(60));
    const auto answer = client.Get("/api/v1/state");
    return answer ? answer->status : 0;
  }

  int own = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  int port = 0;
};

TEST_F(Owner, a_request_between_two_servers_waits_for_the_second_one) {
  auto server = made_server();
  EXPECT_EQ(server->address().port, port);
  EXPECT_EQ(status(), 200);
  server.reset();
  auto waiting = std::async(std::launch::async, [this] { return status(); });
  EXPECT_EQ(waiting.wait_for(std::chrono::seconds(1)), std::future_status::timeout)
      << "refused: the end of a server has shut the owner's socket";
  server = made_server();
  EXPECT_EQ(waiting.get(), 200);
}

TEST_F(Owner, other_machines_reach_an_inherited_socket_only_with_a_key) {
  const int open = socket(AF_INET6, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in6 any{};
  any.sin6_family = AF_INET6;
  if (bind(open, reinterpret_cast<sockaddr*>(&any), sizeof any) != 0) GTEST_SKIP() << "no IPv6";
  listen(open, 16);
  const auto serve = [&](const web::Rules& rules) {
    const web::Server server(spool(), web::Address{}, rules, {}, web::inherited_socket_at(open));
  };
  EXPECT_THROW(serve({}), std::runtime_error);
  web::Rules with_key;
  with_key.key = "0123456789abcdef";
  EXPECT_NO_THROW(serve(with_key));
  close(open);
}

TEST(InheritedSocket, is_one_that_listens_and_of_this_process) {
  setenv("LISTEN_FDS", "1", 1);
  setenv("LISTEN_PID", std::to_string(getpid() + 1).c_str(), 1);
  EXPECT_FALSE(web::inherited_socket()) << "of another process";
  EXPECT_EQ(std::getenv("LISTEN_FDS"), nullptr) << "would be inherited";
  EXPECT_FALSE(web::inherited_socket());
  setenv("LISTEN_FDS", "2", 1);
  setenv("LISTEN_PID", std::to_string(getpid()).c_str(), 1);
  EXPECT_THROW(web::inherited_socket(), std::runtime_error);
  const int silent = socket(AF_INET, SOCK_STREAM, 0);
  EXPECT_THROW(web::inherited_socket_at(silent), std::runtime_error) << "it does not listen";
  listen(silent, 1);
  EXPECT_NO_THROW(web::inherited_socket_at(silent));
  EXPECT_TRUE((static_cast<unsigned>(fcntl(silent, F_GETFD)) & FD_CLOEXEC) != 0);
  close(silent);
  EXPECT_THROW(web::inherited_socket_at(silent), std::runtime_error) << "it is closed";
}

}  // namespace
