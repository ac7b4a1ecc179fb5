// SPDX-License-Identifier: Apache-2.0
// Which axes the lines that were sent have homed: printers report it nowhere.
#pragma once

#include <string>
#include <string_view>

namespace feeder {

class HomedAxes {
 public:
  // A line without number and checksum, when it is sent.
  void sent(std::string_view line);
  // The printer was reset, or another program may have used it.
  void forget() { axes_.clear(); }
  // As Klipper writes them: some of `xyz`.
  const std::string& axes() const { return axes_; }

 private:
  std::string axes_;
};

}  // namespace feeder
