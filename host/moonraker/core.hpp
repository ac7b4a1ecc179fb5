// SPDX-License-Identifier: Apache-2.0
// What the methods of one printer's Moonraker work on. All state of jobs and printers is the
// spooler's; here is only what front ends keep for themselves.
#pragma once

#include <chrono>
#include <string>

#include "host/moonraker/access.hpp"
#include "host/moonraker/hub.hpp"
#include "host/moonraker/printer_view.hpp"
#include "host/moonraker/settings_store.hpp"
#include "host/moonraker/temperature_store.hpp"
#include "host/spooler/spooler.hpp"
#include "host/web/guard.hpp"

namespace moonraker {

struct Core {
  spooler::Spooler& spooler;
  SettingsStore& settings;
  std::string printer;
  Access access;
  web::Guard guard;
  Hub hub{};
  TemperatureStore temperatures{};

  PrinterView view() const { return view_of(spooler, printer); }
};

// Throws Error 401. Counts for the client of a connection; over HTTP the server does that.
[[noreturn]] void refuse_key(Core& core, const Connection* connection, const std::string& why);

// In seconds since the machine was started.
double event_time();
// In seconds since 1970.
double unix_time();

}  // namespace moonraker
