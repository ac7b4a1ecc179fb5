// SPDX-License-Identifier: Apache-2.0
// report.html says what happened, to people with and without scripts, from one file.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "sim/report/html_report.hpp"
#include "sim/report/markup.hpp"
#include "tests/sim/page_reader.hpp"

namespace {

using testing::HasSubstr;
using testing::Not;
using tests::between;

report::Results good_results() {
  report::Results results;
  results.file = "part <1> & \"2\".gcode";
  results.machine = "Prusa Mendel";
  results.outcome = report::Outcome::completed;
  results.clock_hz = 4'000'000;
  results.points_reached = 12;
  results.max_deviation_mm = 0.0114;
  results.length_mm = 9844.8;
  results.simulated_seconds = 159;
  results.axes[0].final_position_mm = 0.05;
  return results;
}

report::Results bad_results() {
  report::Results results = good_results();
  report::Findings& findings = results.findings;
  findings.refused = {{4, "G2 X<1> I2", "echo:Unknown command: \"G2\"", true}};
  findings.warnings = {{9, "M999", "echo:Unknown command", false}};
  findings.refused_count = 1;
  findings.warning_count = 1;
  report::MissedPoint point{.file_line = 7, .text = "G1 X10 E1;</script>", .seconds = 1.25};
  point.axes[0] = {true, 10, 800, 720, 9};
  point.axes[1] = {false, 20, 1600, 1600, 20};
  point.axes[3] = {true, 1, 500, 499, 0.998};
  findings.missed = {point};
  results.points_missed = 40;
  findings.missed_by_axis = {40, 0, 0, 1};
  findings.problems = {"40 points were missed", "1 line was <refused>"};
  results.underruns = 3;
  results.resends = 2;
  results.axes[1].illegal_pulses = 5;
  return results;
}

report::Courses some_courses() {
  report::Courses courses;
  courses.path = {{0, 0, 0, false, 0},
                  {10, 0, 0.2F, false, 0.5},
                  {10, 10, 0.2F, true, 1},
                  {20, 10, 0.4F, true, 2}};
  courses.asked = {
      {2, 0.1, {0, 0, 0}, {10, 0, 0.2F}, false, true},
      {4, 0.2, {10, 0, 0.2F}, {300, 0, 0.2F}, false, false},
      {5, 0.3, {10, 0, 0.2F}, {10, 10, 0.2F}, true, true},
  };
  courses.hotend = {{0, 22, 205, 0.5}, {0.25, 30, 205, 1}};
  courses.bed = {{0, 22, 0, 0}, {0.25, 22, 0, 0}};
  for (std::size_t i = 0; i < courses.axes.size(); ++i) {
    report::AxisCourse& axis = courses.axes[i];
    axis = {report::RangeCourse(0.5), report::RangeCourse(0.5), report::RangeCourse(0.5)};
    for (const double value : {1.0, -2.0, 3.0}) {
      axis.position_mm.put(value);
      axis.speed_mm_s.put(10 * value);
      axis.acceleration_mm_s2.put(100 * value);
    }
    courses.limits[i] = {80, 200, 3000, 10};
  }
  courses.chip.queue_depth = report::RangeCourse(0.001);
  courses.chip.queue_depth.put(3);
  courses.chip.underruns = {{1.5, 3}};
  courses.intervals[0][40] = 9;
  return courses;
}

nlohmann::json data_of(const std::string& page) {
  return nlohmann::json::parse(between(page, "id=\"print-data\">", "</script>"));
}

// The value on the card with this caption, and whether it is good or bad.
std::string card(const std::string& page, const std::string& caption) {
  const std::regex pattern("class=\"fact([^\"]*)\"[^>]*><b>([^<]*)</b><span>" + caption +
                           "</span>");
  std::smatch found;
  return std::regex_search(page, found, pattern) ? found[2].str() + found[1].str() : "none";
}

TEST(ReportPage, is_well_formed_whatever_the_print_was) {
  EXPECT_EQ(tests::fault_in_page(report::to_html(good_results(), some_courses())), "");
  EXPECT_EQ(tests::fault_in_page(report::to_html(bad_results(), some_courses())), "");
  EXPECT_EQ(tests::fault_in_page(report::to_html(good_results(), {})), "");
  EXPECT_EQ(tests::fault_in_page(report::to_html({}, {})), "");
}

TEST(ReportPage, loads_nothing_and_forbids_the_browser_to) {
  const std::string page = report::to_html(bad_results(), some_courses());
  EXPECT_THAT(page, HasSubstr("content=\"default-src 'none';"));
  std::string rest =
      std::regex_replace(page, std::regex("xmlns=\"http://www.w3.org/2000/svg\""), "");
  EXPECT_THAT(rest, Not(testing::ContainsRegex("(https?:)?//[a-z0-9]+\\.")));
  EXPECT_THAT(rest, Not(testing::ContainsRegex("src=|url\\(|@import|<link|<img|<iframe|fetch\\(")));
}

TEST(ReportPage, gives_a_good_print_a_green_badge) {
  const std::string page = report::to_html(good_results(), some_courses());
  EXPECT_THAT(page, HasSubstr("class=\"verdict good\""));
  EXPECT_THAT(page, Not(HasSubstr("class=\"verdict bad\"")));
  for (const char* what :
       {"refused lines", "missed points", "underruns", "illegal pulses", "resends"}) {
    EXPECT_EQ(card(page, what), "0 good") << what;
  }
  EXPECT_EQ(card(page, "time on the printer"), "2 min 39 s");
}

TEST(ReportPage, gives_a_bad_print_a_red_badge_with_the_reasons) {
  const std::string page = report::to_html(bad_results(), some_courses());
  const std::string verdict = between(page, "class=\"verdict bad\"", "</ul>");
  EXPECT_THAT(verdict, HasSubstr("<li>40 points were missed</li>"));
  EXPECT_THAT(verdict, HasSubstr("<li>1 line was &lt;refused&gt;</li>"));
  EXPECT_EQ(card(page, "refused lines"), "1 bad");
  EXPECT_EQ(card(page, "missed points"), "40 bad");
  EXPECT_EQ(card(page, "underruns"), "3 bad");
  EXPECT_EQ(card(page, "illegal pulses"), "5 bad");
  EXPECT_EQ(card(page, "resends"), "2 wary");
}

TEST(ReportPage, is_never_green_where_the_print_faulted_or_was_stopped) {
  report::Results results = good_results();
  results.outcome = report::Outcome::faulted;
  results.fault = "Error:Thermal Runaway";
  EXPECT_THAT(between(report::to_html(results, {}), "class=\"verdict bad\"", "</ul>"),
              HasSubstr("Thermal Runaway"));
  results = good_results();
  results.outcome = report::Outcome::stopped;
  EXPECT_THAT(report::to_html(results, {}), HasSubstr("class=\"verdict wary\""));
  results.findings.problems = {"a line was lost"};
  EXPECT_THAT(report::to_html(results, {}), HasSubstr("class=\"verdict bad\""));
}

TEST(ReportPage, lists_refused_lines_with_text_reason_and_a_link_to_the_place) {
  const std::string page = report::to_html(bad_results(), some_courses());
  const std::string section = between(page, "<section id=\"refused\">", "</section>");
  EXPECT_THAT(tests::text_without_tags(section),
              testing::ContainsRegex(
                  "4 +0.200&nbsp;s +G2 X&lt;1&gt; I2 +echo:Unknown command: &quot;G2&quot;"));
  EXPECT_THAT(
      section,
      HasSubstr("data-t=\"0.2000\" data-places=\"10.000 0.000 0.200 300.000 0.000 0.200\""));
  EXPECT_THAT(between(page, "<section id=\"warnings\">", "</section>"), HasSubstr("M999"));
}

TEST(ReportPage, lists_missed_points_with_the_axes_and_a_link_to_the_place) {
  const std::string page = report::to_html(bad_results(), some_courses());
  const std::string section = between(page, "<section id=\"missed\">", "</section>");
  EXPECT_THAT(section, HasSubstr("X: 40, E: 1"));
  EXPECT_THAT(section, HasSubstr("X -80 steps: 9.000 mm where 10.000 mm are asked<br>E -1 steps"));
  EXPECT_THAT(
      section,
      HasSubstr("data-t=\"1.2500\" data-places=\"10.000 20.000 0.000 9.000 20.000 0.000\""));
  EXPECT_THAT(section, HasSubstr("39 more are not listed"));
  EXPECT_THAT(between(page, "<section id=\"underruns\">", "</section>"),
              HasSubstr("data-t=\"1.5000\""));
}

TEST(ReportPage, marks_problems_in_the_pictures) {
  const std::string page = report::to_html(bad_results(), some_courses());
  const nlohmann::json data = data_of(page);
  ASSERT_EQ(data["missed"].size(), 1U);
  EXPECT_EQ(data["missed"][0]["x"], 10);
  EXPECT_EQ(data["missed"][0]["reached_x"], 9);
  EXPECT_EQ(data["marks"].size(), 2U);
  EXPECT_EQ(data["asked"]["kind"], "01302");  // the pen goes back from where nothing was printed
  EXPECT_EQ(data["chip"]["underruns"][0][1], 3);
  const std::string picture = between(page, "<noscript><svg", "</svg>");
  EXPECT_THAT(picture, HasSubstr("class=\"missed\" cx=\"1000\" cy=\"-2000\""));
}

TEST(ReportPage, shows_the_path_without_scripts) {
  const std::string picture =
      between(report::to_html(good_results(), some_courses()), "<noscript><svg", "</svg>");
  EXPECT_THAT(picture, HasSubstr("M1000 0l0 -1000l1000 0"));  // printed, upwards
  EXPECT_THAT(picture, HasSubstr("var(--asked)"));
}

TEST(ReportPage, packs_courses_so_that_they_can_be_unpacked) {
  const nlohmann::json data = data_of(report::to_html(good_results(), some_courses()));
  const nlohmann::json& speed = data["axes"][2]["speed"];
  EXPECT_EQ(data["axes"][2]["name"], "Z");
  EXPECT_EQ(data["axes"][2]["limits"]["acceleration"], 3000);
  double sum = 0;
  std::vector<double> values;
  for (const auto& difference : speed["low"]) {
    sum += difference.get<double>();
    values.push_back(sum * speed["scale"].get<double>());
  }
  EXPECT_THAT(values, testing::Pointwise(testing::DoubleNear(0.01), {10.0, -20.0, 30.0}));
  EXPECT_EQ(data["path"]["kind"], "0011");
  EXPECT_EQ(data["path"]["x"], nlohmann::json({0, 10000, 0, 10000}));
  EXPECT_EQ(data["path"]["t"], nlohmann::json({0, 500, 500, 1000}));
  EXPECT_EQ(data["heaters"][0]["duty"], nlohmann::json({50, 100}));
}

TEST(ReportPage, has_both_themes_and_fits_a_phone) {
  const std::string page = report::to_html(good_results(), some_courses());
  EXPECT_THAT(page, HasSubstr("prefers-color-scheme: dark"));
  EXPECT_THAT(page, HasSubstr("content=\"width=device-width, initial-scale=1\""));
  EXPECT_THAT(page, HasSubstr("<svg class=\"path\""));
  EXPECT_THAT(page, HasSubstr("viewBox="));
  EXPECT_THAT(page, HasSubstr("start();\n</script>"));  // the scripts, to their end
}

TEST(ReportPage, stays_small_where_the_print_is_long) {
  report::Courses courses = some_courses();
  for (report::AxisCourse& axis : courses.axes) {
    for (int i = 0; i < 200'000; ++i) {
      axis.speed_mm_s.put(200 * std::sin(i));
      axis.acceleration_mm_s2.put(3000 * std::sin(i));
      axis.position_mm.put(i);
    }
  }
  for (int i = 0; i < 200'000; ++i) {
    courses.hotend.push_back({0.25 * i, 205 + std::sin(i), 205, 0.4});
    courses.chip.queue_depth.put(i % 4);
  }
  EXPECT_LT(report::to_html(good_results(), courses).size(), 2'000'000U);
}

TEST(Markup, gives_lengths_in_the_unit_of_their_size) {
  EXPECT_EQ(report::length_text(0), "0.0 µm");
  EXPECT_EQ(report::length_text(0.0114), "11.4 µm");
  EXPECT_EQ(report::length_text(0.25), "250 µm");
  EXPECT_EQ(report::length_text(0.99996), "1.000 mm");
  EXPECT_EQ(report::length_text(9.8448), "9.845 mm");
  EXPECT_EQ(report::length_text(-52.5), "-52.50 mm");
  EXPECT_EQ(report::length_text(9844.8), "9.84 m");
  const std::string page = report::to_html(good_results(), {});
  EXPECT_EQ(card(page, "farthest from the G-code's lines"), "11.4 µm");
  EXPECT_EQ(card(page, "way of the nozzle"), "9.84 m");
}

TEST(Markup, gives_times_as_a_person_reads_them) {
  EXPECT_EQ(report::duration(4.5), "4.5 s");
  EXPECT_EQ(report::duration(59.97), "1 min 00 s");
  EXPECT_EQ(report::duration(159), "2 min 39 s");
  EXPECT_EQ(report::duration(3599.7), "1 h 00 min");
  EXPECT_EQ(report::duration(7290), "2 h 02 min");
}

}  // namespace
