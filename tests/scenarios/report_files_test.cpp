// SPDX-License-Identifier: Apache-2.0
// The report is written however a job ends, and an earlier one is never left in its place.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "directories.hpp"
#include "tests/scenarios/job.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

class ReportFiles : public testing::Test {
 protected:
  ReportFiles() {
    fs::remove_all(folder);
    fs::create_directories(report);
    // Of yesterday.
    scenarios::write_file(report / "report.json", "{\"result\": \"completed\"}");
    scenarios::write_file(report / "report.html", "completed");
    scenarios::write_file(gcode, "G28 X\nG1 X180 F12000\nG1 X0\n");
  }

  std::string json() const { return files::text_of(report / "report.json"); }
  std::string html() const { return files::text_of(report / "report.html"); }

  // A line for a shell in which `stepfabric` is the program; the exit status.
  static int shell(const std::string& line) {
    setenv("STEPFABRIC_BUILD_DIR", BUILD_DIRECTORY, 1);
    const std::string script = "stepfabric=" BUILD_DIRECTORY "/bin/stepfabric; " + line;
    return process::run({.arguments = {"bash", "-c", script}}).exit_status;
  }
  std::string print_line(const std::string& options = "") const {
    return "\"$stepfabric\" print " + gcode.string() + " --report " + report.string() + " " +
           options + " 2> " + (folder / "said").string();
  }

  // Faulted for this reason, in both files, and nothing of the earlier ones.
  void expect_faulted(const std::string& reason) const {
    EXPECT_THAT(json(), HasSubstr("\"result\": \"faulted\""));
    EXPECT_THAT(json(), HasSubstr(reason));
    EXPECT_THAT(html(), HasSubstr(reason));
  }

  fs::path folder = scenarios::scratch_folder();
  fs::path report = folder / "report";
  fs::path gcode = folder / "input.gcode";
};

TEST_F(ReportFiles, say_that_a_full_disk_takes_no_edges_before_anything_moves) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this machine has no /dev/full";
  EXPECT_EQ(shell(print_line("--edges /dev/full")), 2);
  expect_faulted("cannot write /dev/full");
  EXPECT_THAT(json(), HasSubstr("\"cycles\": 0"));
}

TEST_F(ReportFiles, say_that_the_disk_became_full_of_edges) {
  // A limit to the size of files ends writing as a full disk does. 288 000 edges take three times
  // this; the log of the build, which is written too, a third.
  std::string moves = "G28 X\n";
  for (int i = 0; i < 10; ++i) moves += "G1 X180 F12000\nG1 X0\n";
  scenarios::write_file(gcode, moves);
  const std::string limit = "ulimit -f 2000; ";
  EXPECT_EQ(shell(limit + print_line("--edges " + (folder / "edges.csv").string())), 1);
  expect_faulted("cannot write all of");
  EXPECT_THAT(json(), HasSubstr("edges.csv"));
}

// A page has more than this.
TEST_F(ReportFiles, of_an_earlier_job_go_where_no_new_ones_can_be_written) {
  EXPECT_EQ(shell("ulimit -f 2; " + print_line()), 2);
  EXPECT_THAT(files::text_of(folder / "said"), HasSubstr("cannot write"));
  EXPECT_FALSE(fs::exists(report / "report.json"));
  EXPECT_FALSE(fs::exists(report / "report.html"));
  EXPECT_TRUE(fs::is_empty(report));
}

TEST_F(ReportFiles, say_what_was_refused) {
  for (const char* option : {"--edges", "--accept-log"}) {
    EXPECT_EQ(shell(print_line(std::string(option) + " /no/such/folder/file")), 2);
    expect_faulted("cannot write /no/such/folder/file");
    scenarios::write_file(report / "report.json", "{\"result\": \"completed\"}");
    scenarios::write_file(report / "report.html", "completed");
  }
  const std::string serve = "\"$stepfabric\" serve --speed max --until 0.01 --pty " +
                            gcode.string() + " --report " + report.string() + " 2> /dev/null";
  EXPECT_EQ(shell(serve), 2);
  expect_faulted("exists already");
  EXPECT_THAT(files::text_of(gcode), HasSubstr("G28 X"));
}

TEST_F(ReportFiles, are_written_where_the_output_is_not_read) {
  // The reader is gone before the first word.
  EXPECT_EQ(shell(print_line() + " > >(exec true); exit $?"), 0);
  EXPECT_THAT(json(), HasSubstr("\"verdict\": \"good\""));
  fs::remove(report / "report.json");
  const std::string serve =
      "\"$stepfabric\" serve --speed max --until 0.2 --clock-hz 4000000 --pty " +
      (folder / "port").string() + " --report " + report.string();
  EXPECT_EQ(shell("(sleep 0.1; " + serve + " 2>&1; echo $? > " + (folder / "status").string() +
                  ") | true"),
            0);
  EXPECT_EQ(files::text_of(folder / "status"), "0\n");
  EXPECT_THAT(json(), HasSubstr("\"result\": \"stopped\""));
}

// The status is that of a job whose words are read, and its files are the same.
TEST_F(ReportFiles, of_bench_are_written_where_the_output_is_not_read) {
  const std::string bench = "\"$stepfabric\" bench processor --quick --work record --report " +
                            report.string() + " --json " + (folder / "figures.json").string() +
                            " 2> " + (folder / "said").string();
  for (const std::string unread : {"exec true", "head -1 > /dev/null"}) {
    fs::remove(folder / "figures.json");
    EXPECT_EQ(shell(bench + " > >(" + unread + "); exit $?"), 0) << files::text_of(folder / "said");
    EXPECT_THAT(files::text_of(folder / "figures.json"), HasSubstr("\"benchmark\"")) << unread;
    EXPECT_THAT(files::text_of(report / "processor.html"), HasSubstr("</html>")) << unread;
  }
  fs::remove(folder / "figures.json");
  EXPECT_EQ(shell(bench + " >&-"), 0) << files::text_of(folder / "said");
  EXPECT_THAT(files::text_of(folder / "figures.json"), HasSubstr("\"benchmark\""));
}

TEST_F(ReportFiles, are_not_debug_s_which_ends_well_where_its_output_is_not_read) {
  const std::string debug =
      "\"$stepfabric\" debug --port 0 --until 0.01 2> " + (folder / "said").string();
  EXPECT_EQ(shell(debug + " > >(exec true); exit $?"), 0) << files::text_of(folder / "said");
  EXPECT_EQ(shell(debug + " > >(head -1 > /dev/null); exit $?"), 0)
      << files::text_of(folder / "said");
  EXPECT_EQ(shell(debug + " >&-"), 0) << files::text_of(folder / "said");
}

TEST_F(ReportFiles, are_written_where_there_is_no_output) {
  EXPECT_EQ(shell(print_line() + " >&-"), 0) << files::text_of(folder / "said");
  EXPECT_THAT(json(), HasSubstr("\"verdict\": \"good\""));
}

// A file that was opened as stream 1 or 2 would get what is said there.
TEST_F(ReportFiles, and_others_hold_nothing_that_is_said_on_a_closed_stream) {
  const std::string log = (folder / "log").string(), edges = (folder / "edges.csv").string();
  const std::string line = "\"$stepfabric\" print " + gcode.string() + " --report " +
                           report.string() + " --accept-log " + log + " --edges " + edges;
  ASSERT_EQ(shell(line + " > /dev/null 2>&1"), 0);
  const std::string lines = files::text_of(log), rows = files::text_of(edges);
  EXPECT_EQ(shell(line + " <&- >&- 2>&-"), 0);
  EXPECT_EQ(files::text_of(log), lines);
  EXPECT_EQ(files::text_of(edges), rows);
}

// At once: the pipe's other end may never be opened.
TEST_F(ReportFiles, say_that_a_job_was_interrupted_that_waited_for_a_pipe) {
  setenv("STEPFABRIC_BUILD_DIR", BUILD_DIRECTORY, 1);
  const std::string pipe = folder / "pipe", port = folder / "port";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::vector<std::vector<std::string>> jobs{
      {"print", gcode, "--edges", pipe},
      {"print", gcode, "--accept-log", pipe},
      {"serve", "--speed", "max", "--clock-hz", "4000000", "--pty", port, "--edges", pipe},
      {"serve", "--speed", "max", "--clock-hz", "4000000", "--pty", port, "--accept-log", pipe}};
  for (std::vector<std::string> job : jobs) {
    job.insert(job.begin(), BUILD_DIRECTORY "/bin/stepfabric");
    job.insert(job.end(), {"--report", report});
    process::Process program({.arguments = job});
    std::this_thread::sleep_for(3s);
    EXPECT_FALSE(program.ending()) << testing::PrintToString(job);
    program.signal(SIGTERM);
    for (int i = 0; i < 600 && !program.ending(); ++i) std::this_thread::sleep_for(100ms);
    ASSERT_TRUE(program.ending()) << testing::PrintToString(job);
    EXPECT_EQ(program.ending()->exit_status, 130) << testing::PrintToString(job);
    expect_faulted("interrupted");
  }
}

TEST_F(ReportFiles, of_a_job_that_was_killed_say_that_it_has_not_ended) {
  scenarios::write_file(gcode, "G4 S1000\n");
  // The shell becomes the program.
  EXPECT_EQ(shell("(sleep 5; kill -9 $$) & exec " + print_line() + " > /dev/null"), 128 + SIGKILL);
  expect_faulted("has not ended");
  EXPECT_THAT(html(), Not(HasSubstr("completed")));
}

// The input by its name, by a longer way, by a symlink and by a hard link.
TEST_F(ReportFiles, are_all_that_is_written_where_another_file_would_overwrite_the_input) {
  const std::string text = files::text_of(gcode);
  fs::create_symlink(gcode, folder / "symlink");
  fs::create_hard_link(gcode, folder / "hard_link");
  for (const char* name : {"input.gcode", "report/../input.gcode", "symlink", "hard_link"}) {
    for (const char* option : {"--edges", "--accept-log"}) {
      EXPECT_EQ(shell(print_line(std::string(option) + " " + (folder / name).string())), 2) << name;
      EXPECT_EQ(files::text_of(gcode), text) << name;
      EXPECT_THAT(files::text_of(folder / "said"), HasSubstr("would overwrite")) << name;
    }
  }
  const std::string file = (folder / "log").string();
  EXPECT_EQ(shell(print_line("--edges " + file + " --accept-log " + file)), 2);
  EXPECT_THAT(files::text_of(folder / "said"), HasSubstr("would both write"));
  EXPECT_FALSE(fs::exists(file));
  // The report itself.
  fs::copy_file(gcode, report / "report.html", fs::copy_options::overwrite_existing);
  gcode = report / "report.html";
  EXPECT_EQ(shell(print_line()), 2);
  EXPECT_EQ(files::text_of(gcode), text);
}

TEST_F(ReportFiles, of_one_job_are_not_mixed_with_those_of_another) {
  scenarios::write_file(gcode, "G4 S1000\n");
  const std::string first = "(exec " + print_line() +
                            " > /dev/null) & job=$!; for i in {1..600}; do grep -q 'has not "
                            "ended' " +
                            (report / "report.html").string() + " && break; sleep 0.1; done; ";
  const std::string second = "\"$stepfabric\" print " + gcode.string() + " --report " +
                             report.string() + " --until 0.01 2> " + (folder / "second").string() +
                             "; status=$?; kill -9 $job; exit $status";
  EXPECT_EQ(shell(first + second), 2);
  EXPECT_THAT(files::text_of(folder / "second"), HasSubstr("another job writes its report there"));
  expect_faulted("has not ended");
  // A killed job keeps nothing from the next one.
  scenarios::write_file(gcode, "G28 X\n");
  EXPECT_EQ(shell(print_line()), 0);
}

TEST_F(ReportFiles, that_cannot_be_written_are_named_before_anything_moves) {
  fs::remove_all(report);
  scenarios::write_file(report, "precious");
  EXPECT_EQ(shell(print_line()), 2);
  EXPECT_THAT(files::text_of(folder / "said"), HasSubstr(report.string()));
  EXPECT_EQ(files::text_of(report), "precious");
}

}  // namespace
