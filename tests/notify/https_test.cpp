// SPDX-License-Identifier: Apache-2.0
// A webhook over https: its certificate is checked.
#include <gmock/gmock.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <optional>

#include "host/notify/webhook.hpp"
#include "tests/notify/receiver.hpp"
#include "tests/temporary_folder.hpp"

namespace {

using namespace std::chrono_literals;

template <auto end>
struct Ending {
  void operator()(auto* object) const { end(object); }
};
void write_with(const std::string& path, const auto& write) {
  const std::unique_ptr<std::FILE, Ending<std::fclose>> file(std::fopen(path.c_str(), "w"));
  ASSERT_EQ(write(file.get()), 1) << path;
}

// For 127.0.0.1, signed by itself.
void make_certificate(const std::string& key_file, const std::string& file) {
  const std::unique_ptr<EVP_PKEY, Ending<EVP_PKEY_free>> key(EVP_EC_gen("P-256"));
  const std::unique_ptr<X509, Ending<X509_free>> made(X509_new());
  X509_set_version(made.get(), X509_VERSION_3);
  ASN1_INTEGER_set(X509_get_serialNumber(made.get()), 1);
  X509_gmtime_adj(X509_getm_notBefore(made.get()), -3600);
  X509_gmtime_adj(X509_getm_notAfter(made.get()), 3600);
  X509_set_pubkey(made.get(), key.get());
  const std::unique_ptr<X509_EXTENSION, Ending<X509_EXTENSION_free>> name(
      X509V3_EXT_conf_nid(nullptr, nullptr, NID_subject_alt_name, "IP:127.0.0.1"));
  X509_add_ext(made.get(), name.get(), -1);
  ASSERT_NE(X509_sign(made.get(), key.get(), EVP_sha256()), 0);
  write_with(key_file, [&](std::FILE* out) {
    return PEM_write_PrivateKey(out, key.get(), nullptr, nullptr, 0, nullptr, nullptr);
  });
  write_with(file, [&](std::FILE* out) { return PEM_write_X509(out, made.get()); });
}

class Https : public testing::Test {
 protected:
  Https() {
    make_certificate(key, certificate);
    server.emplace(certificate.c_str(), key.c_str());
    server->Post("/hook", [this](const httplib::Request&, httplib::Response&) { ++requests; });
    port = server->bind_to_any_port("127.0.0.1");
    thread = std::thread([this] { server->listen_after_bind(); });
    server->wait_until_ready();
  }
  ~Https() override {
    unsetenv("SSL_CERT_FILE");
    server->stop();
    thread.join();
  }
  // Whether it becomes true.
  static bool soon(const std::function<bool()>& fits) {
    for (int i = 0; i < 6000 && !fits(); ++i) std::this_thread::sleep_for(10ms);
    return fits();
  }
  void send() {
    hook = std::make_unique<notify::Webhook>(
        notify::webhook_of("https://127.0.0.1:" + std::to_string(port) + "/hook"),
        [this](const std::string& line) {
          const std::scoped_lock lock(mutex);
          log += line + "\n";
        });
    hook->take({.kind = notify::Kind::job_finished, .id = "1"});
  }

  TemporaryFolder folder;
  const std::string key = folder.path() / "key", certificate = folder.path() / "certificate";
  std::atomic<int> requests = 0;
  std::optional<httplib::SSLServer> server;
  int port = 0;
  std::thread thread;
  std::mutex mutex;
  std::string log;
  std::unique_ptr<notify::Webhook> hook;
};

TEST_F(Https, a_receiver_with_a_certificate_that_no_one_knows_gets_nothing) {
  send();
  EXPECT_TRUE(soon([&] {
    const std::scoped_lock lock(mutex);
    return log.contains("tried again");
  }));
  hook.reset();
  EXPECT_EQ(requests, 0) << log;
}

TEST_F(Https, a_receiver_with_a_certificate_that_is_known_gets_events) {
  setenv("SSL_CERT_FILE", certificate.c_str(), 1);
  send();
  EXPECT_TRUE(soon([&] { return requests == 1; })) << log;
  hook.reset();
}

}  // namespace
