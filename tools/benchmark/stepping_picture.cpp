// SPDX-License-Identifier: Apache-2.0
// The picture and the page.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "tools/benchmark/gnuplot.hpp"
#include "tools/benchmark/published_figures.hpp"
#include "tools/benchmark/stepping_report.hpp"

namespace benchmarks {

namespace {

struct Bar {
  std::string name;
  double steps_per_million_clocks{};
  int colour{};
};

// Null where there is none, as in a quick run.
const LoopRates* one_axis(const Figures& figures, const DriverGuard& guard) {
  const auto is_it = [&](const LoopRates& rates) {
    return rates.axes == 1 && std::string_view(rates.guard.driver) == guard.driver;
  };
  const auto found = std::ranges::find_if(figures.loops, is_it);
  return found == figures.loops.end() ? nullptr : &*found;
}

std::vector<Bar> bars_of(const Comparison& comparison) {
  std::vector<Bar> bars;
  for (const PublishedFigure& figure : published_figures) {
    bars.push_back({figure.system, figure.steps_per_million_clocks(), 0x8a929c});
  }
  const LoopRates& hardware = *one_axis(comparison.figures[0], no_driver);
  const LoopRates& software = *one_axis(comparison.figures[1], no_driver);
  const auto add = [&](std::string name, const Limit& limit, int colour) {
    bars.push_back({std::move(name), 1e6 / limit.interval_clocks, colour});
  };
  add("StepFabric in software", software.lines.clean, 0xc8374b);
  add("StepFabric in hardware", hardware.lines.punctual, 0x2f62b8);
  // Where both have to wait for a motor driver.
  const DriverGuard& driver = real_drivers.front();
  const std::string with = fmt::format(", {}", driver.driver);
  const LoopRates* with_driver = one_axis(comparison.figures[1], driver);
  if (with_driver) add("software" + with, with_driver->lines.clean, 0xe08a96);
  with_driver = one_axis(comparison.figures[0], driver);
  if (with_driver) add("hardware" + with, with_driver->lines.punctual, 0x8aa9dc);
  std::ranges::stable_sort(bars, {}, &Bar::steps_per_million_clocks);
  return bars;
}

}  // namespace

std::string to_svg(const Comparison& comparison) {
  fmt::memory_buffer script;
  const auto add = [&]<class... Arguments>(fmt::format_string<Arguments...> format,
                                           Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(script), format, std::forward<Arguments>(arguments)...);
  };
  const auto bars = bars_of(comparison);
  add("$bars << EOD\n");
  for (std::size_t i = 0; i < bars.size(); ++i) {
    add("{} {:.4g} {} \"{}\"\n", i, bars[i].steps_per_million_clocks, bars[i].colour, bars[i].name);
  }
  add("EOD\n");
  for (const Figures& figures : comparison.figures) {
    add("${} << EOD\n", name_of(figures.stepping));
    for (const Share& share : figures.shares) {
      add("{:.1f} {:.3f} {}\n", comparison.clock_hz / double(share.interval_clocks) / 1000,
          100 * share.busy, share.clean ? 1 : 0);
    }
    add("EOD\n");
  }
  add("set border 3 lc rgb '#8a929c'\nset tics nomirror out scale 0.6 textcolor rgb '#4a525c'\n"
      "set grid lc rgb '#e6e9ed' lt 1\nset multiplot\n"
      "set lmargin at screen 0.27\nset rmargin at screen 0.66\nset bmargin at screen 0.18\n"
      "set tmargin at screen 0.9\nset title 'steps of one axis per million clocks' textcolor rgb "
      "'#2b323a'\n"
      "set logscale x\nset xrange [5:1000000]\nset format x '10^{{%T}}'\nunset key\n"
      "set yrange [-0.6:{}]\nset style fill solid noborder\n"
      "plot $bars using (1):0:(5):2:($1-0.36):($1+0.36):3:ytic(4) with boxxyerrorbars lc rgb "
      "variable, $bars using ($2*1.25):1:(sprintf('%.0f',$2)) with labels left textcolor rgb "
      "'#4a525c' font ',11'\n",
      static_cast<double>(bars.size()) - 0.4);
  add("set lmargin at screen 0.74\nset rmargin at screen 0.98\nset title 'processor, four axes' "
      "textcolor rgb '#2b323a'\nset xlabel 'thousand ticks/s at {:.3g} MHz' textcolor rgb "
      "'#4a525c'\nset xrange [1:200]\nset yrange [0:105]\nset ytics auto\nset format x '%g'\n"
      "set format y '%g %%'\nset key top left\n"
      "plot $software using 1:2 with linespoints pt 7 ps 0.5 lw 2 lc rgb '#c8374b' title "
      "'software', $hardware using 1:2 with linespoints pt 7 ps 0.5 lw 2 lc rgb '#2f62b8' title "
      "'hardware'\nunset multiplot\n",
      comparison.clock_hz * 1e-6);
  return svg_of("stepping", {1100, 420}, fmt::to_string(script));
}

std::string to_html(const Comparison& comparison) {
  std::string escaped;
  for (const char character : to_table(comparison)) {
    if (character == '<') {
      escaped += "&lt;";
    } else if (character == '&') {
      escaped += "&amp;";
    } else {
      escaped += character;
    }
  }
  std::string published;
  for (const PublishedFigure& figure : published_figures) {
    published += fmt::format(
        "<tr><td>{}</td><td>{:g} MHz</td><td>{:.0f}</td><td>{:.0f}</td><td>{}</td>"
        "<td><a href=\"{}\">source</a></td></tr>\n",
        figure.system, figure.clock_mhz, figure.steps_per_second(),
        figure.steps_per_million_clocks(), figure.remark, figure.source);
  }
  return fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Stepping</title>\n"
      "<style>body{{font:15px/1.5 Lato,\"DejaVu Sans\",sans-serif;color:#2b323a;max-width:1180px;"
      "margin:24px auto;padding:0 20px}}svg{{width:100%;height:auto}}td{{padding:3px 12px 3px 0}}"
      "pre{{background:#f3f5f7;padding:14px;overflow-x:auto}}</style>\n"
      "<h1>Stepping in hardware and in software</h1>\n{}\n<pre>{}</pre>\n"
      "<h2>Other systems, one axis, as published</h2>\n"
      "<table><tr><td>system</td><td>clock</td><td>steps/s</td><td>per million clocks</td><td></td>"
      "<td></td></tr>\n{}</table></html>\n",
      to_svg(comparison), escaped, published);
}

}  // namespace benchmarks
