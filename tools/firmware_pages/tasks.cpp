// SPDX-License-Identifier: Apache-2.0
// Writes the rows of the table of tasks as Markdown.
#include "firmware_pages/pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "application/task_table.hpp"

namespace firmware_pages {
namespace {

using application::Deadline;
using application::TaskRow;

// 1 234 567
std::string grouped(std::int64_t number) {
  std::string text = fmt::format("{}", number);
  if (text.size() < 5) return text;
  for (std::size_t place = text.size(); place > 3; place -= 3) text.insert(place - 3, " ");
  return text;
}

std::string text_of(units::Milliseconds time) {
  return time.count() % 1000 == 0 ? fmt::format("{} s", time.count() / 1000)
                                  : fmt::format("{} ms", time.count());
}

std::string text_of(const Deadline& deadline) {
  std::vector<std::string> limits;
  if (deadline.clocks != 0) limits.push_back(grouped(deadline.clocks) + " clocks");
  if (deadline.bytes != 0) limits.push_back(fmt::format("{} bytes", deadline.bytes));
  if (deadline.time.count() != 0) limits.push_back(text_of(deadline.time));
  return limits.empty() ? "-" : fmt::format("{}", fmt::join(limits, ", or "));
}

std::string row_of(const TaskRow& task) {
  const std::string each = task.allowance == 0 ? "each pass" : "each round";
  return fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", task.priority, task.name,
                     task.period.count() == 0 ? each : text_of(task.period), text_of(task.deadline),
                     task.allowance == 0 ? "-" : grouped(task.allowance), grouped(task.budget),
                     task.reason.empty() ? "-" : task.reason);
}

}  // namespace

std::string tasks() {
  std::string text =
      "# Tasks\n\n"
      "Generated from the [table of tasks](task_table.hpp): do not edit. They run in this order, "
      "which makes a round; nothing preempts\n"
      "them. Allowance and budget are in clocks. The allowance must be in hand before a task "
      "begins while motion needs lines, and no bound\n"
      "may be above it; without one the task runs in each pass. The budget is what "
      "[`timing --tasks`](../../tools/timing) holds the measured\n"
      "times against.\n\n"
      "| order | task | period | deadline | allowance | budget | if it is missed |\n"
      "|---|---|---|---|---|---|---|\n";
  std::int64_t all = 0;
  for (const TaskRow& task : application::task_table) {
    text += row_of(task);
    all += task.budget;
  }
  return text + fmt::format(
                    "\nAll budgets together: {} clocks. `./stepfabric timing --schedule` lists at "
                    "which clock and baud rate the deadlines are\n[met](../../tools/timing/"
                    "schedule.md): what they come to in passes follows from the bounds of the "
                    "image.\n",
                    grouped(all));
}

}  // namespace firmware_pages
