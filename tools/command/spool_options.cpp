// SPDX-License-Identifier: Apache-2.0
// The options of the job `spool`, and what its help says.
#include <CLI/CLI.hpp>

#include "tools/command/spool_job.hpp"

namespace command {

void add_options(CLI::App& app, SpoolOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "spool", "Take print jobs over HTTP, queue them durably, and print them, until Ctrl-C.");
  job.add_option("--data", options.data,
                 "folder for queue, files and journals; default: stepfabric/spool in "
                 "$XDG_DATA_HOME or ~/.local/share")
      ->type_name("DIR");
  job.add_option("--listen", options.listen,
                 "address of the web server; other than loopback only with --key")
      ->type_name("HOST:PORT")
      ->capture_default_str();
  job.add_option("--printer", options.printers,
                 "a printer's name and serial port, or simulated[:N]; may be repeated")
      ->type_name("NAME=PORT")
      ->capture_default_str();
  job.add_option("--database", options.database,
                 "a PostgreSQL database for the queue of several spoolers; default: a file in the "
                 "folder of --data. The password is in ~/.pgpass or PGPASSFILE, or the address is "
                 "service=NAME")
      ->type_name("postgresql://USER@HOST/NAME");
  job.add_option("--key", options.key,
                 "file with the key that clients send as X-Api-Key; readable for you alone")
      ->type_name("FILE");
  job.add_option("--host-name", options.host_names,
                 "a name by which browsers may call this server, apart from its addresses")
      ->type_name("NAME");
  job.add_flag("!--no-build", options.builds,
               "start the programs as they are, as an installed service does");
  job.add_flag(
      "--allow-root", options.allows_root,
      "run as root although other machines reach it, as in a container; elsewhere start it "
      "as another user");
  CLI::Option* const moonraker =
      job.add_option(
             "--moonraker", options.moonraker,
             "serve Moonraker's API too, for Mainsail, Fluidd and slicers; one port for each "
             "printer, counting up from this one")
          ->type_name("HOST[:7125]");
  job.add_option("--frontend", options.frontend,
                 "folder with Mainsail or Fluidd, which is served with Moonraker's API")
      ->type_name("DIR")
      ->needs(moonraker);
  job.add_option(
         "--webhook", options.webhooks,
         "POST notifications as JSON to this http or https URL, or to the one in a file that "
         "only you can read; may be repeated")
      ->type_name("URL|@FILE");
  CLI::Option* const mqtt =
      job.add_option("--mqtt", options.mqtt,
                     "publish notifications and the printers' states to an MQTT broker")
          ->type_name("HOST[:1883]");
  job.add_option("--mqtt-login", options.mqtt_login,
                 "file with the broker's user and password in two lines; readable for you alone")
      ->type_name("FILE")
      ->needs(mqtt);
  job.add_option("--mqtt-topic", options.mqtt_topic, "that all MQTT topics begin with")
      ->type_name("TOPIC")
      ->capture_default_str()
      ->needs(mqtt);
  job.add_option("--baud", options.baud, "speed of the serial ports")
      ->check(CLI::Range(300, 10'000'000))
      ->capture_default_str();
  job.add_option("--bed-clear-limit", options.bed_clear_limit_h,
                 "so long after a person has said that a bed is clear a job may start there; 0: "
                 "no limit")
      ->type_name("HOURS")
      ->check(CLI::Range(0, 10'000))
      ->capture_default_str();
  job.add_option("--pause-limit", options.pause_limit_min,
                 "switch the hotend of a paused job off after so many minutes, and heat it again "
                 "before the job goes on; 0: never")
      ->type_name("MINUTES")
      ->check(CLI::Range(0, 10'000))
      ->capture_default_str();
  job.add_option("--simulation-speed", options.simulation_speed,
                 "real: simulated printers in real time; max: as fast as possible")
      ->check(CLI::IsMember({"real", "max"}))
      ->capture_default_str();
  job.footer(
      R"(Open the address in a browser. In a slicer add a printer of host type OctoPrint with this
address; http://HOST:PORT/printers/NAME sends to one printer only.

An upload is checked whole by the firmware's planner before it is printed; a file with refused lines
is never printed. A job starts when its turn has come and a person has confirmed that the bed is
clear. One process for each printer feeds it and goes on printing if this one ends: after Ctrl-C
too, and the next `spool` with the same --data attaches to it again.

With --moonraker 127.0.0.1 the first printer's Moonraker is at http://127.0.0.1:7125/; the command
BED_CLEAR, a macro in front ends, confirms that the bed is clear.

With --database several of these, each on its machine with its printers and its --data, have one
queue: what is uploaded at one is printed by the first free printer of any. The files are in the
database. Each printer's name is unique; a lease keeps a second spooler from using it. Without the
server prints go on, uploads are answered 503, and it is connected to again by itself.

Notifications (--webhook, --mqtt): a bed to be cleared, a job started, paused, finished, cancelled,
failed, refused or interrupted, a printer that waits for a person, one that is lost or back. A
receiver that is slow or away holds up nothing; host/notify/README.md has the forms.

A socket that systemd hands over (LISTEN_FDS) takes the place of --listen; host/systemd has units.

Exit status: 0 after Ctrl-C, 2 bad usage, or it could not start.)");
}

}  // namespace command
