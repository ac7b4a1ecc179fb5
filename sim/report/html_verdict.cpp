// SPDX-License-Identifier: Apache-2.0
// Verdict, cards and the lists of what went wrong.
#include <algorithm>

#include "sim/report/html_parts.hpp"
#include "sim/report/page_data.hpp"

namespace report {

namespace {

constexpr const char* tick =
    "<svg viewBox=\"0 0 40 40\" aria-hidden=\"true\"><circle cx=\"20\" cy=\"20\" r=\"19\" "
    "fill=\"currentColor\"/><path d=\"M11 20.5l6.5 6.5L30 14\" fill=\"none\" "
    "stroke=\"var(--sheet)\" stroke-width=\"4\"/></svg>";
constexpr const char* cross =
    "<svg viewBox=\"0 0 40 40\" aria-hidden=\"true\"><circle cx=\"20\" cy=\"20\" r=\"19\" "
    "fill=\"currentColor\"/><path d=\"M13 13l14 14M27 13L13 27\" fill=\"none\" "
    "stroke=\"var(--sheet)\" stroke-width=\"4\"/></svg>";
constexpr const char* pause =
    "<svg viewBox=\"0 0 40 40\" aria-hidden=\"true\"><circle cx=\"20\" cy=\"20\" r=\"19\" "
    "fill=\"currentColor\"/><path d=\"M15 12v16M25 12v16\" fill=\"none\" stroke=\"var(--sheet)\" "
    "stroke-width=\"4\"/></svg>";

std::uint64_t illegal_pulses(const Results& results) {
  std::uint64_t count = 0;
  for (const AxisResult& axis : results.axes) count += axis.illegal_pulses;
  return count;
}

std::uint64_t lost_steps(const Results& results) {
  std::uint64_t count = 0;
  for (const AxisResult& axis : results.axes) {
    count += axis.slipped_steps + axis.frame_steps + axis.disabled_pulses;
  }
  return count;
}

enum class Mark : std::uint8_t { none, good, bad, wary };

constexpr const char* class_of(Mark mark) {
  switch (mark) {
    case Mark::none:
      return "";
    case Mark::good:
      return " good";
    case Mark::bad:
      return " bad";
    case Mark::wary:
      return " wary";
  }
  return "";
}

void add_fact(Page& page, const std::string& value, const char* what, Mark mark = Mark::none,
              const char* target = nullptr) {
  if (target != nullptr) {
    add(page, "<a class=\"fact{}\" href=\"#{}\"><b>{}</b><span>{}</span></a>\n", class_of(mark),
        target, value, what);
  } else {
    add(page, "<div class=\"fact{}\"><b>{}</b><span>{}</span></div>\n", class_of(mark), value,
        what);
  }
}

void add_count(Page& page, std::uint64_t count, const char* what, const char* target = nullptr) {
  add_fact(page, grouped(count), what, count == 0 ? Mark::good : Mark::bad,
           count == 0 ? nullptr : target);
}

// Two places that are to be seen together, for the page's scripts.
template <class Number>
std::string places(const std::array<Number, 3>& one, const std::array<Number, 3>& other) {
  return fmt::format(" data-places=\"{:.3f} {:.3f} {:.3f} {:.3f} {:.3f} {:.3f}\"", one[0], one[1],
                     one[2], other[0], other[1], other[2]);
}

// A link that the page's scripts follow to a time and, if there are any, to places.
std::string time_link(double seconds, const std::string& places = {}) {
  return fmt::format("<a href=\"#path\" data-t=\"{:.4f}\"{}>{:.3f}&nbsp;s</a>", seconds, places,
                     seconds);
}

void add_more(Page& page, std::uint64_t count, std::size_t listed) {
  if (count > listed) {
    add(page, "<p class=\"note\">{} more are not listed.</p>\n", grouped(count - listed));
  }
}

void add_lines(Page& page, const char* id, const char* title, const std::vector<RefusedLine>& lines,
               std::uint64_t count, const Results& results, const Courses& courses) {
  if (count == 0) return;
  add(page,
      "<section id=\"{}\"><h2>{}: {}</h2><div class=\"scroll\"><table><tr><th>line</th>"
      "<th>answered</th><th class=\"text\">text</th><th class=\"text\">reason</th></tr>\n",
      id, title, grouped(count));
  for (const RefusedLine& line : lines) {
    const RefusalPlace place = place_of(line, results, courses);
    const std::string seen = place.moves ? places(place.from, place.to) : "";
    add(page,
        "<tr><td>{}</td><td>{}</td><td class=\"text\">{}</td><td class=\"text\">{}</td></tr>\n",
        line.file_line, place.known ? time_link(place.seconds, seen) : "–", escaped(line.text),
        escaped(line.reason));
  }
  add(page, "</table></div>\n");
  add_more(page, count, lines.size());
  add(page, "</section>\n");
}

std::string with_breaks(std::string text) {
  for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i)) {
    text.replace(i, 1, "<br>");
  }
  return text;
}

void add_missed(Page& page, const Results& results) {
  const Findings& findings = results.findings;
  if (results.points_missed == 0) return;
  add(page, "<section id=\"missed\"><h2>Missed points: {}</h2>\n<p class=\"note\">",
      grouped(results.points_missed));
  const char* between = "";
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    if (findings.missed_by_axis[i] > 0) {
      add(page, "{}{}: {}", between, axis_titles[i], grouped(findings.missed_by_axis[i]));
      between = ", ";
    }
  }
  add(page,
      "</p>\n<div class=\"scroll\"><table><tr><th>line</th><th>time</th>"
      "<th class=\"text\">text</th><th class=\"text\">missed at the nearest by</th></tr>\n");
  for (const MissedPoint& point : findings.missed) {
    std::array<double, 3> wanted{}, reached{};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      wanted[i] = point.axes[i].wanted_mm;
      reached[i] = point.axes[i].reached_mm;
    }
    add(page,
        "<tr><td>{}</td><td>{}</td><td class=\"text\">{}</td><td class=\"text\">{}</td></tr>\n",
        point.file_line, time_link(point.seconds, places(wanted, reached)), escaped(point.text),
        with_breaks(escaped(words_of(point))));
  }
  add(page, "</table></div>\n");
  add_more(page, results.points_missed, findings.missed.size());
  add(page, "</section>\n");
}

void add_underruns(Page& page, const Results& results, const Courses& courses) {
  if (results.underruns == 0) return;
  add(page, "<section id=\"underruns\"><h2>Underruns: {}</h2><div class=\"scroll\"><p>",
      grouped(results.underruns));
  for (const Underruns& some : courses.chip.underruns) {
    add(page, "{}{} ", time_link(some.seconds),
        some.count > 1 ? fmt::format("&nbsp;({})", some.count) : "");
  }
  add(page,
      "</p></div><p class=\"note\">The queue of the step generator was empty while the machine "
      "moved.</p></section>\n");
}

}  // namespace

void add_verdict(Page& page, const Results& results) {
  const bool good = results.good() && results.fault.empty();
  if (good && results.outcome == Outcome::completed) {
    add(page,
        "<div class=\"verdict good\" id=\"verdict\">{}<div><b>Good print</b><p>{} of {} points of "
        "the file reached{}, nothing refused, at most {} off its lines{}.</p></div></div>\n",
        tick, grouped(results.points_reached),
        grouped(results.points_reached + results.points_missed),
        results.points_shaped == 0 ? " to the step" : "",
        length_text(std::max(results.max_deviation_mm, results.max_shaping_mm)),
        results.points_shaped == 0 ? "" : " with input shaping or linear advance");
    return;
  }
  if (good && results.outcome == Outcome::stopped) {
    add(page,
        "<div class=\"verdict wary\" id=\"verdict\">{}<div><b>Stopped</b><p>Nothing went wrong "
        "until then.</p></div></div>\n",
        pause);
    return;
  }
  add(page, "<div class=\"verdict bad\" id=\"verdict\">{}<div><b>Bad print</b><ul>\n", cross);
  if (!results.fault.empty()) add(page, "<li>{}</li>\n", escaped(results.fault));
  for (const std::string& problem : results.findings.problems) {
    if (problem != results.fault) add(page, "<li>{}</li>\n", escaped(problem));
  }
  if (results.fault.empty() && results.findings.problems.empty()) {
    add(page, "<li>{}</li>\n", name_of(results.outcome));
  }
  add(page, "</ul></div></div>\n");
}

void add_facts(Page& page, const Results& results) {
  const Findings& findings = results.findings;
  add(page, "<div class=\"facts\">\n");
  add_count(page, findings.refused_count, "refused lines", "refused");
  add_count(page, results.points_missed, "missed points", "missed");
  add_count(page, results.underruns, "underruns", "underruns");
  add_count(page, illegal_pulses(results), "illegal pulses", "axes");
  add_fact(page, grouped(results.resends), "resends",
           results.resends == 0 ? Mark::good : Mark::wary);
  add_fact(page, duration(results.simulated_seconds), "time on the printer");
  add_count(page, lost_steps(results), "steps lost otherwise", "axes");
  if (findings.warning_count > 0) {
    add_fact(page, grouped(findings.warning_count), "unknown codes that move nothing", Mark::wary,
             "warnings");
  }
  if (findings.lines_lost > 0) add_count(page, findings.lines_lost, "lines without an answer");
  add_fact(page, grouped(results.points_reached - results.points_shaped),
           "points reached to the step");
  add_fact(page, length_text(results.max_deviation_mm), "farthest from the G-code's lines");
  if (results.points_shaped > 0) {
    add_fact(page, grouped(results.points_shaped), "points with input shaping or advance");
    add_fact(page, length_text(results.max_shaping_mm), "corners rounded by at most");
  }
  add_fact(page, length_text(results.length_mm), "way of the nozzle");
  add_fact(page, fmt::format("{:.3g} MHz", results.clock_hz * 1e-6), "clock of the chip");
  add_fact(page, fmt::format("{:.1f} %", results.processor_busy_percent), "processor busy");
  add(page, "</div>\n");
}

void add_problems(Page& page, const Results& results, const Courses& courses) {
  const Findings& findings = results.findings;
  add_lines(page, "refused", "Refused lines", findings.refused, findings.refused_count, results,
            courses);
  add_missed(page, results);
  add_underruns(page, results, courses);
  add_lines(page, "warnings", "Warnings: lines that move nothing", findings.warnings,
            findings.warning_count, results, courses);
}

}  // namespace report
