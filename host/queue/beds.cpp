// SPDX-License-Identifier: Apache-2.0
// Which printers' beds are clear: what the next start needs.
#include "host/queue/bed.hpp"
#include "host/queue/now.hpp"
#include "host/queue/queue.hpp"

namespace queue {

std::int64_t Queue::read_bed(const std::string& printer) {
  Statement row(*database_, "SELECT clear FROM beds WHERE printer = ?");
  row.bind(printer);
  return row.step() ? row.integer(0) : static_cast<std::int64_t>(Bed::not_clear);
}

void Queue::write_bed(const std::string& printer, std::int64_t bed) {
  Statement(*database_,
            "INSERT INTO beds(printer, clear, said_ms) VALUES(?, ?, 0) ON CONFLICT(printer) DO "
            "UPDATE SET clear = excluded.clear")
      .bind(printer)
      .bind(bed)
      .run();
}

std::optional<std::int64_t> Queue::clear_since(const std::string& printer) {
  Statement row(*database_, "SELECT said_ms FROM beds WHERE printer = ? AND clear = ?");
  row.bind(printer).bind(static_cast<std::int64_t>(Bed::clear));
  if (!row.step()) return std::nullopt;
  return row.integer(0);
}

bool Queue::bed_is_clear(const std::string& printer) {
  return read_bed(printer) == static_cast<std::int64_t>(Bed::clear);
}

bool Queue::bed_is_taken(const std::string& printer) {
  return read_bed(printer) == static_cast<std::int64_t>(Bed::taken);
}

std::set<std::string> Queue::clear_beds() {
  Statement rows(*database_, "SELECT printer FROM beds WHERE clear = ?");
  rows.bind(static_cast<std::int64_t>(Bed::clear));
  std::set<std::string> printers;
  while (rows.step()) printers.insert(rows.text(0));
  return printers;
}

void Queue::set_bed_clear(const std::string& printer, bool clear) {
  Transaction transaction(*database_);
  require_lease(printer);
  write_bed(printer, static_cast<std::int64_t>(clear ? Bed::clear : Bed::not_clear));
  Statement(*database_, "UPDATE beds SET said_ms = ? WHERE printer = ?")
      .bind(now_ms())
      .bind(printer)
      .run();
  transaction.commit();
}

}  // namespace queue
