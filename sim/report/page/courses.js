// SPDX-License-Identifier: Apache-2.0
// Which courses the page shows.
const marks = data.marks.map((mark) => [mark.t, 'bad']);
const underruns = data.chip.underruns.map(([ t ]) => [t, 'bad']);

function makeCharts() {
  new Chart('temperatures', {
    unit : '\u00b0C',
    height : 190,
    low : 0,
    high : 60,
    marks,
    series : heaters.flatMap(
        (heater,
         i) => [{label : heater.name, tint : 'xz'[i], t : heater.t, values : heater.celsius}, {
          label : 'target',
          tint : 'xz'[i],
          t : heater.t,
          values : heater.target,
          dashed : true,
          digits : 0
        }])
  });
  heaters.forEach(
      (heater, i) => new Chart('temperatures', {
        title : `${heater.name}: heater duty`,
        unit : '%',
        height : 90,
        high : 100,
        series : [
          {label : 'gate open', tint : 'xz'[i], t : heater.t, values : heater.duty, digits : 0}
        ]
      }));
  for (const i of [2, 3]) {
    new Chart('positions', {
      title : i === 2 ? 'Z, height' : 'E, filament pushed',
      unit : 'mm',
      height : 120,
      marks,
      low : Infinity,
      high : -Infinity,
      series : [ {label : axes[i].name, tint : 'xyze'[i], range : axes[i].position, digits : 3} ]
    });
  }
  axes.forEach((axis, i) => {
    const {speed, acceleration, jerk} = axis.limits, tint = 'xyze'[i];
    const kilohertz = speed * axis.limits.steps_per_mm / 1000;
    new Chart('speeds', {
      title : `${axis.name}: limit ${number(speed, 0)} mm/s (${number(kilohertz, 1)} kHz)`,
      unit : 'mm/s',
      height : 110,
      marks,
      limits : [ {value : speed}, {value : -speed} ],
      series : [ {label : 'speed', tint, range : axis.speed} ]
    });
    const jump = acceleration + jerk / data.half_window_s;
    new Chart('accelerations', {
      title : `${axis.name}: limit ${
          number(acceleration, 0)} mm/s\u00b2, with the jump at a corner ${number(jump, 0)}`,
      unit : 'mm/s\u00b2',
      height : 110,
      marks,
      limits : [
        {value : acceleration}, {value : -acceleration}, {value : jump, dashed : true},
        {value : -jump, dashed : true}
      ],
      series : [ {label : 'acceleration', tint, range : axis.acceleration, digits : 0} ]
    });
  });
  new Chart('chip', {
    title : 'Step generator: segments in the queue, underruns in red',
    unit : '',
    height : 110,
    high : 3,
    marks : underruns,
    series : [ {label : 'waiting', tint : 'accent', range : queueDepth, digits : 0} ]
  });
  new Chart('chip', {
    title : 'Processor',
    unit : '%',
    height : 110,
    high : 100,
    marks : underruns,
    series : [ {label : 'busy', tint : 'busy', range : busy, digits : 0} ]
  });
  charts.forEach(listenTo);
}

function drawCharts() {
  for (const chart of charts) chart.draw();
}
