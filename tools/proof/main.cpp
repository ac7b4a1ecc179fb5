// SPDX-License-Identifier: Apache-2.0
// `prove` as a program of its own: the tests call it without building the model of the chip.
#include <fmt/format.h>

#include <cstdlib>
#include <exception>

#include "tools/command/exit_status.hpp"
#include "tools/proof/run.hpp"

int main(int count, char** arguments) {
  CLI::App app("Tries the formal proofs of StepFabric.", "prove");
  proof::Options options;
  proof::add_options(app, options);
  std::string build = STEPFABRIC_BUILD_FOLDER;
  app.add_option("--build", build, "folder in whose `proofs` everything is tried")
      ->capture_default_str();
  try {
    app.parse(count, arguments);
    return proof::prove(options, STEPFABRIC_PROJECT_FOLDER, build) ? command::success
                                                                   : command::failure;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? command::success : command::bad_input;
  } catch (const std::exception& error) {
    fmt::print(stderr, "prove: {}\n", error.what());
    return command::bad_input;
  }
}
