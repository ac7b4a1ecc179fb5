// SPDX-License-Identifier: Apache-2.0
// Models of hosts: when each sends the next line, and how it reacts to replies.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace host_link::test {

using Milliseconds = long;

class HostModel {
 public:
  explicit HostModel(std::vector<std::string> job) : job_(std::move(job)) {}
  virtual ~HostModel() = default;

  // One reply line, without its end.
  virtual void hear(const std::string& line, Milliseconds now) = 0;
  // What it sends now, if anything: whole lines.
  virtual std::string speak(Milliseconds now) = 0;
  // All lines sent and answered, as far as this host knows.
  virtual bool done() const = 0;
  // The number of the job's first line.
  virtual int first_number() const = 0;
  // It has received something at which the real host ends its print.
  bool ended() const { return ended_; }

 protected:
  // The line as the host writes it, with number and checksum.
  static std::string frame(int number, std::string_view text, std::string_view separator);

  std::vector<std::string> job_;
  bool ended_ = false;
};

// Printrun's printcore: a boolean that any ok and any Resend sets, no time-out at all,
// M105 polls between.
std::unique_ptr<HostModel> printcore(std::vector<std::string> job);
// OctoPrint: acknowledgements counted to one, 50 lines of history, a simulated ok after
// a bare Resend.
std::unique_ptr<HostModel> octoprint(std::vector<std::string> job);
// Cura: four lines at the start, one more for each ok, goes on blindly after six seconds.
std::unique_ptr<HostModel> cura(std::vector<std::string> job);

}  // namespace host_link::test
