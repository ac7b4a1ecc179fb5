// SPDX-License-Identifier: Apache-2.0
// Packages are installed on a machine whose apt is in use, and errors are shown.
#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "directories.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace {

using testing::HasSubstr;

// Calls need_host_packages as root with a script in place of apt-get, and without waiting.
class HostPackages : public testing::Test {
 protected:
  HostPackages() {
    program("id", "echo 0");
    program("sleep", ":");
  }
  // `script`: the body of apt-get. Its calls are listed in the file `calls`.
  process::Captured need(const std::string& package, const std::string& script) const {
    program("apt-get", "echo \"$*\" >> '" + (folder.path() / "calls").string() + "'\n" + script);
    const std::string commands = "PATH='" + folder.path().string() +
                                 "':$PATH\n"
                                 "say() { echo \"$*\" >&2; }\n"
                                 ". '" PROJECT_DIRECTORY "/tools/environment/host_packages.sh'\n" +
                                 "need_host_packages " + package;
    return process::capture({.arguments = {"bash", "-euc", commands}});
  }
  std::size_t calls(const std::string& command) const {
    const std::string text = files::text_of(folder.path() / "calls");
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(command, at)) != std::string::npos; ++at) ++count;
    return count;
  }

 private:
  void program(const std::string& name, const std::string& body) const {
    folder.write(name, "#!/bin/sh\n" + body + "\n");
    std::filesystem::permissions(folder.path() / name, std::filesystem::perms::owner_all);
  }
  TemporaryFolder folder;
};

// Fails with `message` until it has been called `times` times.
std::string failing(int times, const std::string& message) {
  return "[ $(grep -c . \"$(dirname \"$0\")/calls\") -gt " + std::to_string(times) +
         " ] || { echo '" + message + "' >&2; exit 100; }";
}

TEST_F(HostPackages, are_installed_by_one_call_where_nothing_is_in_the_way) {
  const auto result = need("bubblewrap", "");
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_EQ(result.output, "installing on this machine: bubblewrap\n");
  EXPECT_EQ(calls("\n"), 1u);
  EXPECT_EQ(calls("install -y --no-install-recommends bubblewrap\n"), 1u);
}

class AptLock : public HostPackages, public testing::WithParamInterface<const char*> {};

TEST_P(AptLock, of_another_process_is_waited_for) {
  const std::string message = std::string("E: Could not get lock ") + GetParam();
  const auto result = need("proot", failing(20, message + ". It is held by process 7"));
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_EQ(result.output,
            "installing on this machine: proot\n"
            "another apt process is at work on this machine; waiting for it\n");
  EXPECT_EQ(calls("install -y"), 21u);
  EXPECT_EQ(calls("update"), 0u);
}

INSTANTIATE_TEST_SUITE_P(files, AptLock,
                         testing::Values("/var/lib/dpkg/lock-frontend", "/var/lib/apt/lists/lock",
                                         "/var/cache/apt/archives/lock"));

TEST_F(HostPackages, give_up_where_the_lock_stays) {
  const auto result =
      need("proot", "echo 'E: Could not get lock /var/lib/dpkg/lock' >&2; exit 100");
  EXPECT_NE(result.exit_status, 0);
  EXPECT_THAT(result.output, HasSubstr("Could not get lock"));
}

TEST_F(HostPackages, are_looked_for_in_new_lists_where_the_old_ones_lack_them) {
  const auto result = need("proot", failing(1, "E: Unable to locate package proot"));
  EXPECT_EQ(result.exit_status, 0);
  EXPECT_EQ(calls("update"), 1u);
  EXPECT_EQ(calls("install -y"), 2u);
}

TEST_F(HostPackages, that_do_not_exist_are_an_error_that_apt_explains) {
  const auto result = need("none", failing(9, "E: Unable to locate package none"));
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_THAT(result.output, HasSubstr("E: Unable to locate package none"));
}

}  // namespace
