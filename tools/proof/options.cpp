// SPDX-License-Identifier: Apache-2.0
// The options of the job, for the command and for the small program alike.
#include "tools/proof/run.hpp"

namespace proof {

void add_options(CLI::App& job, Options& options) {
  job.add_option("names", options.names,
                 "proofs or mutations to try; without any, all that have no valid record")
      ->type_name("NAME...");
  job.add_flag(
      "--quick", options.quick,
      "only the proofs that take seconds, and no mutations; of --mutants only the bench of the "
      "file itself,\nthose that take less than 5 s, and the comparison of netlists");
  job.add_flag("--all", options.all, "also those that have a valid record");
  auto* only = job.add_flag_callback(
      "--mutations", [&options] { options.proofs = false; },
      "only the mutations: faults put into a copy of the sources, each of which must be found");
  job.add_flag_callback(
         "--no-mutations", [&options] { options.mutations = false; }, "only the proofs")
      ->excludes(only);
  auto* mutants =
      job.add_flag("--mutants", options.mutants,
                   "systematic mutants of rtl/motion and rtl/thermal (NAME: a file or entity) on "
                   "benches, proofs\n"
                   "and comparison of netlists; what was found is kept in <build>/mutants");
  mutants->excludes(only);
  job.add_option("--sample", options.sample,
                 "also about N of those that have a valid record, chosen by the seed;\n"
                 "with --mutants: only N of them, chosen by the seed")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  job.add_option(
      "--seed", options.seed,
      "of the sample. Default: the number of the day, so that every record is tried again\n"
      "within some days; with --mutants, a hash of the files");
  auto* recorded = job.add_flag("--recorded", options.campaign.recorded,
                                "without those that testbench/proofs/mutants lists as not tried")
                       ->needs(mutants);
  job.add_flag("--untried", options.campaign.untried,
               "only those that testbench/proofs/mutants lists as not tried; --record keeps what\n"
               "it says of the others")
      ->needs(mutants)
      ->excludes(recorded);
  job.add_flag(
         "--surviving", options.campaign.surviving,
         "only those that testbench/proofs/mutants lists as surviving, for example with a new\n"
         "bench; --record keeps what it says of the others")
      ->needs(mutants)
      ->excludes(recorded);
  job.add_flag(
      "--record", options.record,
      "write what holds and is caught into testbench/proofs/recorded.tsv; with --mutants,\n"
      "the result of each into testbench/proofs/mutants");
  job.add_option("--json", options.json, "write the outcome")->type_name("FILE.json");
  job.add_option("--jobs", options.jobs,
                 "number of parallel trials; 0: one for each processor core")
      ->capture_default_str();
  job.add_option("--limit", options.limit_seconds, "time limit of a solver call, in seconds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  job.footer(
      "The properties are in testbench/proofs/FOLDER, the proofs in the lists of FOLDER/proofs,\n"
      "the faults in those of FOLDER/mutations. A proof by induction holds for all times; a "
      "bounded\n"
      "one for its number of clocks after the start. Where one fails, a trace (VCD) is left in\n"
      "<build>/proofs/NAME.\n"
      "A record is valid as long as the tools' versions and all sources, settings and programs\n"
      "that the trial depends on are the same; comments in VHDL do not matter.\n"
      "With --mutants, 97 % of those that are not equivalent must be killed, and each survivor\n"
      "must be listed in testbench/proofs/mutants.\n"
      "Exit status: 0 everything holds and every mutation was caught, 1 not, 2 bad usage.");
}

}  // namespace proof
