// SPDX-License-Identifier: Apache-2.0
// systemd's own tools judge the units and the udev rules, and find faults that are put in.
#include <gmock/gmock.h>

#include <filesystem>
#include <string>
#include <vector>

#include "directories.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const fs::path units = fs::path(PROJECT_DIRECTORY) / "host" / "systemd";

std::string replaced(std::string text, const std::string& old, const std::string& now) {
  const std::size_t place = text.find(old);
  EXPECT_NE(place, std::string::npos) << old;
  return place == std::string::npos ? text : text.replace(place, old.size(), now);
}

class Units : public testing::Test {
 protected:
  // With a program that exists here.
  Units() {
    service = replaced(files::text_of(units / "stepfabric-spool.service"),
                       "ExecStart=/usr/lib/stepfabric/bin/stepfabric", "ExecStart=/bin/true");
    socket = files::text_of(units / "stepfabric-spool.socket");
  }
  // What `systemd-analyze verify` says of both.
  std::string verified() const {
    folder.write("stepfabric-spool.service", service);
    folder.write("stepfabric-spool.socket", socket);
    return said({"systemd-analyze", "verify", "--man=no",
                 folder.path() / "stepfabric-spool.service",
                 folder.path() / "stepfabric-spool.socket"})
        .output;
  }
  process::Captured said(const std::vector<std::string>& arguments) const {
    return process::capture({.arguments = arguments, .has_input = false});
  }
  process::Captured judged(const std::string& rules) const {
    folder.write("70-stepfabric.rules", rules);
    return said(
        {"udevadm", "verify", "--resolve-names=never", folder.path() / "70-stepfabric.rules"});
  }

  TemporaryFolder folder;
  std::string service, socket;
};

TEST_F(Units, have_no_fault_that_systemd_finds) { EXPECT_THAT(verified(), IsEmpty()); }

TEST_F(Units, faults_are_found) {
  const std::string good = service;
  service = replaced(good, "ProtectSystem=", "ProtectSytem=");
  EXPECT_THAT(verified(), HasSubstr("ProtectSytem"));
  service = replaced(good, "KillMode=process", "KillMode=spooler");
  EXPECT_THAT(verified(), HasSubstr("kill mode"));
  service = replaced(good, "@system-service", "@sytem-service");
  EXPECT_THAT(verified(), HasSubstr("sytem-service"));
  service = good;
  socket = replaced(socket, "ListenStream=127.0.0.1:5080", "ListenStream=127.0.0.1:508000");
  EXPECT_THAT(verified(), Not(IsEmpty()));
}

// 0 is no exposure at all, 100 that of a service without any restriction.
TEST_F(Units, leave_the_service_little_exposed) {
  const auto exposure = [&](const std::string& text) {
    folder.write("stepfabric-spool.service", text);
    return said({"systemd-analyze", "security", "--offline=true", "--threshold=18",
                 folder.path() / "stepfabric-spool.service"})
        .exit_status;
  };
  EXPECT_EQ(exposure(service), 0);
  EXPECT_NE(exposure(replaced(service, "CapabilityBoundingSet=", "")), 0);
}

TEST_F(Units, the_spooler_alone_is_ended_by_a_stop_and_keeps_its_user) {
  EXPECT_THAT(service, HasSubstr("\nKillMode=process\n"));
  EXPECT_THAT(service, HasSubstr("\nOOMPolicy=continue\n"));
  EXPECT_THAT(service, Not(HasSubstr("\nDynamicUser=")));
}

TEST_F(Units, the_udev_rules_are_rules) {
  const std::string rules = files::text_of(units / "70-stepfabric.rules");
  const auto good = judged(rules);
  EXPECT_EQ(good.exit_status, 0) << good.output;
  EXPECT_NE(judged(replaced(rules, "ATTRS{idVendor}==", "ATTRS{idVendor}=")).exit_status, 0);
  EXPECT_NE(judged(replaced(rules, "SYMLINK+=\"", "SYMLINK+=")).exit_status, 0);
}

TEST_F(Units, the_user_may_open_serial_ports) {
  fs::create_directories(folder.path() / "root" / "etc");
  folder.write("root/etc/group", "dialout:x:20:\n");
  const auto made = said({"systemd-sysusers", "--root=" + (folder.path() / "root").string(),
                          units / "stepfabric.sysusers.conf"});
  EXPECT_EQ(made.exit_status, 0) << made.output;
  EXPECT_THAT(files::text_of(folder.path() / "root/etc/passwd"), HasSubstr("stepfabric:"));
  EXPECT_THAT(files::text_of(folder.path() / "root/etc/group"),
              HasSubstr("dialout:x:20:stepfabric"));
}

}  // namespace
