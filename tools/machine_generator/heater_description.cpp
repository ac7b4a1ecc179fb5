// SPDX-License-Identifier: Apache-2.0
// Reads heaters in the firmware's units: parts of full power, slopes, millidegrees.
#include "machine_generator/heater_description.hpp"

#include <cmath>
#include <initializer_list>

namespace machine_generator {
namespace {

// Bounds are those of the firmware's arithmetic, or of the registers.
constexpr std::int64_t thousand = 1000;
constexpr std::int64_t million = 1'000'000;
constexpr std::int64_t max_millicelsius = 1'000'000;
constexpr std::int64_t max_milliohms = 1'000'000'000'000;
constexpr std::int64_t thermal_channels = 4;
constexpr std::int64_t two_billion = 2'000'000'000;
constexpr std::int64_t max_milliwatts = 10'000'000;

units::Millicelsius celsius(Reader& reader, const char* key) {
  return quantity<units::Millicelsius>(
      reader.scaled(key, thousand, -max_millicelsius, max_millicelsius));
}

units::Milliohms ohms(Reader& reader, const char* key) {
  return units::Milliohms(reader.scaled(key, thousand, 1, max_milliohms));
}

thermal::NtcProperties thermistor(Reader reader) {
  const thermal::NtcProperties ntc{
      .resistance_25c = ohms(reader, "resistance_25c_ohms"),
      .beta_kelvin = static_cast<std::int32_t>(reader.scaled("beta_k", 1, 1, 100'000))};
  reader.finish();
  return ntc;
}

// Gains are given as parts of full power and kept as parts of 65535.
thermal::ControllerGains gains(Reader reader) {
  const auto duty = [&reader](const char* key) {
    const std::int64_t millionths = reader.scaled(key, million, 0, 1'000 * million);
    return static_cast<std::int32_t>((millionths * thermal::full_duty + million / 2) / million);
  };
  const thermal::ControllerGains gains{.duty_per_celsius = duty("proportional_per_c"),
                                       .duty_per_celsius_second = duty("integral_per_c_s"),
                                       .duty_per_celsius_per_second = duty("derivative_s_per_c"),
                                       .feed_forward_duty_per_celsius = duty("feed_forward_per_c")};
  reader.finish();
  return gains;
}

// Energies and conductances become slopes: what full power does in a second, and what part of the
// difference to the surroundings is lost in one.
thermal::HeaterModel model(Reader reader, double milliwatts) {
  const auto milli = [&reader](const char* key, std::int64_t least) {
    return reader.scaled(key, thousand, least, two_billion);
  };
  const auto percent = [&reader](const char* key, std::int64_t least, std::int64_t most) {
    return static_cast<std::int32_t>(reader.scaled(key, 100, least, most));
  };
  const auto rounded = [](double value) { return static_cast<std::int32_t>(std::llround(value)); };
  const auto heater = static_cast<double>(milli("heater_j_per_k", 1));
  const auto block = static_cast<double>(milli("block_j_per_k", 1));
  const auto through = static_cast<double>(milli("heater_to_block_w_per_k", 1));
  const double all = heater + block;
  constexpr double steepest_milliwatts = 6.0;  // per mJ/K: what 32 bits hold in the comparison
  if (milliwatts / all > steepest_milliwatts) {
    reader.fail("block_j_per_k", "is so small that full power heats by more than 6 K/s");
  }
  const auto part_per_second = [&](double milliwatts_per_kelvin) {
    return rounded(milliwatts_per_kelvin / all * million);
  };
  // PLA, from room temperature: 1.24 g/cm^3, about 1.9 J/(g K), filament of 1.75 mm.
  constexpr double joules_per_mm_kelvin = 1.24e-3 * 1.9 * 2.405;
  const thermal::HeaterProperties properties{
      .rise = rounded(milliwatts / all * thousand),
      .loss = part_per_second(static_cast<double>(milli("loss_w_per_k", 0))),
      .fan_loss = part_per_second(static_cast<double>(milli("fan_loss_w_per_k", 0))),
      .filament_loss =
          part_per_second(reader.truth("melts_filament") ? joules_per_mm_kelvin * thousand : 0),
      .heater_lag = units::Milliseconds(std::llround(heater * block / all / through * thousand)),
      .sensor_lag = units::Milliseconds(milli("sensor_lag_s", 1)),
      .least_power = percent("power_least", 1, 100),
      .most_power = percent("power_most", 100, 400),
      .least_loss = percent("loss_least", 1, 100),
      .most_loss = percent("loss_most", 100, 400),
      .draught = percent("draught", 0, 200),
      .missing_limit =
          quantity<units::Millicelsius>(reader.scaled("missing_limit_k", thousand, 1, 16'000)),
      .window = units::Milliseconds(reader.scaled("window_s", thousand, 100, 60'000))};
  reader.finish();
  return thermal::HeaterModel(properties);
}

std::uint8_t channel(Reader& reader, const char* key) {
  return static_cast<std::uint8_t>(reader.whole(key, 0, thermal_channels - 1));
}

application::HeaterDescription heater(Reader& reader, Reader& thermistors) {
  const auto milliwatts =
      static_cast<double>(reader.scaled("heater_watts", thousand, 1, max_milliwatts));
  if (celsius(reader, "min_c") >= celsius(reader, "max_c")) {
    reader.fail("min_c", "must be below max_c");
  }
  const std::string kind = reader.text("thermistor");
  if (!thermistors.has(kind)) reader.fail("thermistor", "names none of [thermistors]");
  return {.sensor_channel = channel(reader, "sensor_channel"),
          .heater_channel = channel(reader, "heater_channel"),
          .thermistor = thermistor(thermistors.table(kind)),
          .min = celsius(reader, "min_c"),
          .max = celsius(reader, "max_c"),
          .gains = gains(reader.table("control")),
          .model = model(reader.table("model"), milliwatts)};
}

void require_channels_apart(Reader& heater, std::initializer_list<Reader*> others) {
  for (const char* key : {"sensor_channel", "heater_channel"}) {
    for (Reader* other : others) {
      if (channel(heater, key) == channel(*other, key)) {
        heater.fail(key, "is the channel of another heater already");
      }
    }
  }
}

// Two equal references define no line, and a capacitor never reaches the supply.
application::ConverterDescription converter(Reader reader) {
  const auto milli = [&reader](const char* key) {
    return static_cast<std::int32_t>(reader.scaled(key, thousand, 1, two_billion));
  };
  if (ohms(reader, "reference_low_ohms") >= ohms(reader, "reference_high_ohms")) {
    reader.fail("reference_low_ohms", "must be below reference_high_ohms");
  }
  if (milli("threshold_v") >= milli("supply_v")) {
    reader.fail("threshold_v", "must be below supply_v");
  }
  const application::ConverterDescription description{
      .capacitor_picofarads = milli("capacitor_nf"),
      .reference_low = ohms(reader, "reference_low_ohms"),
      .reference_high = ohms(reader, "reference_high_ohms"),
      .supply_millivolts = milli("supply_v"),
      .threshold_millivolts = milli("threshold_v")};
  reader.finish();
  return description;
}

}  // namespace

void read_heaters(Reader& root, application::MachineDescription& machine) {
  Reader thermistors = root.table("thermistors");
  Reader hotend = root.table("hotend");
  Reader bed = root.table("bed");
  machine.hotend = heater(hotend, thermistors);
  machine.bed = heater(bed, thermistors);
  machine.min_extrusion = celsius(hotend, "min_extrusion_c");
  if (machine.min_extrusion > machine.hotend.max) {
    hotend.fail("min_extrusion_c", "must not be above max_c");
  }
  require_channels_apart(bed, {&hotend});
  if (machine.second_tool) {
    Reader tool = root.table("tool_1");
    Reader second = tool.table("hotend");
    machine.second_tool->hotend = heater(second, thermistors);
    require_channels_apart(second, {&hotend, &bed});
    second.finish();
  }
  machine.converter = converter(root.table("temperature_converter"));
  for (const Reader* reader : {&hotend, &bed}) reader->finish();
}

}  // namespace machine_generator
