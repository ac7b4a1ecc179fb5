// SPDX-License-Identifier: Apache-2.0
// Builds what the spooler starts, and runs it with its web server.
#include "tools/command/spool_job.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host/moonraker/server.hpp"
#include "host/notify/mqtt.hpp"
#include "host/notify/notifier.hpp"
#include "host/notify/webhook.hpp"
#include "host/spooler/spooler.hpp"
#include "host/web/server.hpp"
#include "tools/command/build.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/output.hpp"
#include "tools/command/signals.hpp"

namespace command {

namespace {

namespace fs = std::filesystem;

fs::path usual_data() {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && *data != '\0') return fs::path(data) / "stepfabric" / "spool";
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') {
    throw std::runtime_error("no HOME: name a folder by --data");
  }
  return fs::path(home) / ".local" / "share" / "stepfabric" / "spool";
}

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "an unnamed machine";
}

spooler::Settings settings_of(const SpoolOptions& options) {
  const fs::path programs = build_folder() / "bin";
  return {.data = fs::absolute(options.data.empty() ? usual_data() : options.data),
          .printers = spooler::printers_of(options.printers),
          .feeder_program = programs / "stepfabric_feeder",
          .tool_program = programs / "stepfabric",
          .baud = options.baud,
          .bed_clear_limit = std::chrono::hours(options.bed_clear_limit_h),
          .pause_limit = std::chrono::minutes(options.pause_limit_min),
          .simulation_speed = options.simulation_speed,
          .database = options.database,
          .place = host_name() + " (" + options.listen + ")"};
}

const std::string as_another_user =
    "Start it as another user: sudo -u NAME, or User= in a systemd unit";

void refuse_to_serve_as_root(const web::Address& address, const SpoolOptions& options) {
  if (geteuid() != 0 || options.allows_root) return;
  if (!web::is_loopback(address.host)) {
    throw std::runtime_error("other machines reach " + web::written(address) + ": not as root. " +
                             as_another_user + "; --allow-root runs as root all the same");
  }
  say_to(stderr, "stepfabric: the spooler runs as root. {}\n", as_another_user);
}

// One for each printer, and what their front ends keep.
struct Moonrakers {
  std::unique_ptr<moonraker::SettingsStore> settings;
  std::vector<std::unique_ptr<moonraker::Server>> servers;
};

Moonrakers moonrakers_of(const SpoolOptions& options, const web::Rules& rules,
                         const spooler::Settings& settings, spooler::Spooler& spooler) {
  Moonrakers all;
  if (options.moonraker.empty()) return all;
  web::Address address = web::address_of(options.moonraker, moonraker::usual_port);
  all.settings = std::make_unique<moonraker::SettingsStore>(settings.data / "front_ends.db");
  for (const spooler::PrinterSpec& printer : settings.printers) {
    if (!all.servers.empty() && address.port != 0 && ++address.port == 0) {
      throw std::runtime_error("no port is left for the Moonraker of " + printer.name);
    }
    all.servers.push_back(
        std::make_unique<moonraker::Server>(spooler, *all.settings,
                                            moonraker::Options{.printer = printer.name,
                                                               .address = address,
                                                               .rules = rules,
                                                               .frontend = options.frontend}));
  }
  return all;
}

// Where notifications go, as the command line says it. Read before anything is started.
struct Receivers {
  std::vector<notify::WebhookAddress> webhooks;
  std::optional<notify::MqttOptions> mqtt;
};

Receivers receivers_of(const SpoolOptions& options) {
  Receivers receivers;
  for (const std::string& text : options.webhooks) {
    receivers.webhooks.push_back(notify::webhook_of(text));
  }
  if (!options.mqtt.empty()) {
    receivers.mqtt = notify::mqtt_options(options.mqtt, options.mqtt_login, options.mqtt_topic);
  }
  return receivers;
}

std::unique_ptr<notify::Notifier> notifier_of(const Receivers& receivers,
                                              spooler::Spooler& spooler) {
  const notify::Log log = [](const std::string& line) { say_to(stderr, "stepfabric: {}\n", line); };
  std::vector<std::unique_ptr<notify::Sink>> sinks;
  for (const notify::WebhookAddress& address : receivers.webhooks) {
    sinks.push_back(std::make_unique<notify::Webhook>(address, log));
  }
  if (receivers.mqtt) sinks.push_back(std::make_unique<notify::Mqtt>(*receivers.mqtt, log));
  if (sinks.empty()) return nullptr;
  return std::make_unique<notify::Notifier>(spooler, std::move(sinks));
}

void greet(const web::Server& server, const spooler::Settings& settings,
           const Moonrakers& moonrakers) {
  say("spooling on http://{}/, data in {}\n", web::written(server.address()),
      settings.data.string());
  for (const spooler::PrinterSpec& printer : settings.printers) {
    say("  {}: {}\n", printer.name, printer.port.empty() ? "simulated" : printer.port.string());
  }
  for (const auto& each : moonrakers.servers) {
    say("  Moonraker of {}: http://{}/\n", each->printer(), web::written(each->address()));
  }
  say("Ctrl-C ends it; a print goes on, and the next spool attaches to it.\n");
  std::fflush(stdout);
}

}  // namespace

int spool(const SpoolOptions& options) {
  let_writes_fail();
  const spooler::Settings settings = settings_of(options);
  const std::optional<web::InheritedSocket> socket = web::inherited_socket();
  const web::Address address = socket ? socket->address : web::address_of(options.listen);
  const web::Rules rules{.key = options.key.empty() ? "" : web::read_key(options.key),
                         .names = options.host_names};
  refuse_to_serve_as_root(address, options);
  if (!options.moonraker.empty()) {
    refuse_to_serve_as_root(web::address_of(options.moonraker, moonraker::usual_port), options);
  }
  const Receivers receivers = receivers_of(options);
  if (options.builds) build({"stepfabric_feeder", "firmware"});
  spooler::Spooler spooler(settings);
  const web::Server server(spooler, address, rules, {}, socket);
  const Moonrakers moonrakers = moonrakers_of(options, rules, settings, spooler);
  const std::unique_ptr<notify::Notifier> notifier = notifier_of(receivers, spooler);
  greet(server, settings, moonrakers);
  spooler.run(interrupt_requested);
  return success;
}

}  // namespace command
