// SPDX-License-Identifier: Apache-2.0
// Containers that the page's scripts fill, and the picture for readers without scripts.
#include "sim/report/axis_courses.hpp"
#include "sim/report/html_parts.hpp"
#include "sim/report/path_picture.hpp"

namespace report {

void add_path(Page& page, const Results& results, const Courses& courses) {
  add(page,
      "<section id=\"path\"><h2>The path as printed</h2>\n"
      "<noscript>{}</noscript>\n<div class=\"scripted\">\n"
      "<div class=\"bar\"><button id=\"fit\">Fit</button><button id=\"closer\" "
      "aria-label=\"closer\">+</button><button id=\"farther\" aria-label=\"farther\">−</button>"
      "<button id=\"in-space\">In space</button><button id=\"one-layer\">One layer</button>"
      "<button id=\"show-asked\">G-code</button><button id=\"show-travel\">Travel</button>"
      "<button id=\"by-speed\">Speed</button></div>\n"
      "<div class=\"view\"><canvas id=\"path-canvas\" role=\"img\" "
      "aria-label=\"path as printed\"></canvas><div class=\"tip\" id=\"path-tip\"></div></div>\n"
      "<div class=\"slide\"><label for=\"layer\">Layer</label><input id=\"layer\" type=\"range\" "
      "min=\"1\" step=\"1\"><output id=\"layer-out\"></output></div>\n"
      "<div class=\"slide\"><label for=\"time\">Time</label><input id=\"time\" type=\"range\" "
      "min=\"0\" max=\"2000\" step=\"1\"><output id=\"time-out\"></output></div>\n"
      "<div class=\"bar\"><button id=\"play\">Play</button><span class=\"now\" "
      "id=\"now\"></span></div>\n"
      "<div class=\"key\"><span><span id=\"ramp-low\"></span> <span class=\"ramp\" "
      "id=\"ramp\"></span> <span id=\"ramp-high\"></span></span>"
      "<span><i style=\"background:var(--asked);height:7px\"></i>asked by the G-code</span>"
      "<span><i style=\"background:var(--travel)\"></i>travel</span>"
      "<span><i style=\"background:var(--bad)\"></i>missed (⊗) or refused (dashes)</span></div>\n"
      "<p class=\"note\">Drag or use two fingers to move, wheel or pinch to zoom; in space a drag "
      "turns, with Shift it moves.</p></div>\n"
      "<p class=\"note\">Drawn from the step pulses: points within {} steps of the lines between "
      "their neighbours are left out. The band under it is what the G-code asks.</p></section>\n",
      path_picture(results, courses), ToolPath::tolerance_steps);
}

void add_courses(Page& page) {
  constexpr const char* spans =
      "<div class=\"bar scripted\"><button data-span=\"whole\">Whole</button><button "
      "data-span=\"printing\">Printing</button><button data-span=\"closer\" "
      "aria-label=\"closer\">+</button><button data-span=\"farther\" "
      "aria-label=\"farther\">−</button></div>\n";
  add(page,
      "<section><h2>Temperature and heater duty</h2>{}<div class=\"scripted\" "
      "id=\"temperatures\"></div>\n"
      "<p class=\"note scripted\">Drag over a chart to see that time nearer; double-click for all "
      "of it; a click shows that moment in the path. On a touch screen: pinch, and slide.</p>"
      "<noscript><p class=\"note\">The courses are drawn by scripts.</p></noscript></section>\n",
      spans);
  add(page,
      "<section class=\"scripted\"><h2>Height and filament</h2>{}<div class=\"grid2\" "
      "id=\"positions\"></div></section>\n",
      spans);
  add(page,
      "<section class=\"scripted\"><h2>Speed of each axis</h2>{}<div class=\"grid2\" "
      "id=\"speeds\"></div></section>\n",
      spans);
  const double h_ms = 1000 * AxisCourses::half_window_seconds;
  add(page,
      "<section class=\"scripted\"><h2>Acceleration of each axis</h2>{}<div class=\"grid2\" "
      "id=\"accelerations\"></div><p class=\"note\">From the step edges, each at its own clock: an "
      "edge says that the axis is half-way between two steps, and between edges it moves evenly. "
      "Speed is the mean over {:.0f} ms, acceleration the second difference over twice {:.0f} ms, "
      "which is the mean with the weight of a triangle: peaks shorter than that look lower. Steps "
      "are rounded: an axis slower than the fastest has up to 2 steps / ({:.0f} ms)² of noise (for "
      "12.5 µm: 250 mm/s²). A jump of speed at a corner, which the limits permit (jerk), looks "
      "like jump / {:.0f} ms; the dotted line is the limit with such a jump. Homing ends at once "
      "where an end stop closes. Limits are those of the machine's description; M201, M203 and "
      "M205 may change them in a print.</p></section>\n",
      spans, 2 * h_ms, h_ms, h_ms, h_ms);
  add(page,
      "<section class=\"scripted\"><h2>Queue and processor</h2>{}<div class=\"grid2\" "
      "id=\"chip\"></div><p class=\"note\">The depth is looked at once a millisecond; underruns "
      "are counted by the chip.</p></section>\n"
      "<section class=\"scripted\"><h2>Time between two steps of an axis</h2><canvas "
      "id=\"intervals\" role=\"img\" aria-label=\"how often each time between steps occurred\" "
      "style=\"height:220px\"></canvas><div class=\"key\"><span><i "
      "style=\"background:var(--x)\"></i>X</span><span><i style=\"background:var(--y)\"></i>Y"
      "</span><span><i style=\"background:var(--z)\"></i>Z</span><span><i "
      "style=\"background:var(--e)\"></i>E</span><span>upright: number of steps</span></div>"
      "</section>\n",
      spans);
}

}  // namespace report
