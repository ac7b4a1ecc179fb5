// SPDX-License-Identifier: Apache-2.0
// How much filament is left on which printer.
#include "host/queue/queue.hpp"

namespace queue {

std::optional<double> Queue::filament_left(const std::string& printer) {
  Statement row(*database_, "SELECT left_mm FROM filaments WHERE printer = ?");
  row.bind(printer);
  if (!row.step()) return std::nullopt;
  return row.real(0);
}

std::map<std::string, double> Queue::filaments_left() {
  Statement rows(*database_, "SELECT printer, left_mm FROM filaments");
  std::map<std::string, double> left;
  while (rows.step()) left[rows.text(0)] = rows.real(1);
  return left;
}

void Queue::set_filament_left(const std::string& printer, std::optional<double> millimetres) {
  Transaction transaction(*database_);
  require_lease(printer);
  Statement(*database_, "DELETE FROM filaments WHERE printer = ?").bind(printer).run();
  if (millimetres) {
    Statement(*database_, "INSERT INTO filaments(printer, left_mm) VALUES(?, ?)")
        .bind(printer)
        .bind(*millimetres)
        .run();
  }
  transaction.commit();
}

bool Queue::has_filament_for(const Job& job, const std::string& printer) {
  return job.filament_mm <= filament_left(printer).value_or(job.filament_mm);
}

// More than was said to be there is possible: a spool holds more than its label says.
void Queue::use_filament(const std::string& printer, double millimetres) {
  Statement(*database_,
            "UPDATE filaments SET left_mm = CASE WHEN left_mm > ? THEN left_mm - ? ELSE 0 END "
            "WHERE printer = ?")
      .bind(millimetres)
      .bind(millimetres)
      .bind(printer)
      .run();
}

}  // namespace queue
