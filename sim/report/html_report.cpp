// SPDX-License-Identifier: Apache-2.0
// The frame of the report's page.
#include "sim/report/html_report.hpp"

#include "sim/report/html_parts.hpp"
#include "sim/report/page_data.hpp"
#include "sim/report/page_files.hpp"

namespace report {

namespace {

// The browser itself refuses whatever is not in this file.
constexpr const char* policy =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

}  // namespace

std::string to_html(const Results& results, const Courses& courses) {
  Page page;
  add(page,
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{} – StepFabric</title>\n<style>\n{}</style>\n"
      "<noscript><style>.scripted {{ display: none; }}</style></noscript>\n"
      "</head><body><main>\n",
      policy, escaped(results.file), page_style);
  add(page, "<header><h1>{}</h1><p class=\"note\">on the simulated {}</p></header>\n",
      escaped(results.file.empty() ? "print of a host program" : results.file),
      escaped(results.machine));
  add_verdict(page, results);
  add_facts(page, results);
  add_problems(page, results, courses);
  add_path(page, results, courses);
  add_courses(page);
  add_heaters(page, results);
  add_axes(page, results);
  add_messages(page, results);
  add_chip(page, results);
  add(page,
      "<script type=\"application/json\" id=\"print-data\">{}</script>\n"
      "<script>\n{}</script>\n</main></body></html>\n",
      page_data(results, courses), page_script);
  return fmt::to_string(page);
}

}  // namespace report
