#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# PrusaSlicer slices a plate, and its own dialog sends it to a print host, with the key 0123456789abcdef.
# Usage: prusaslicer.sh octoprint|prusalink http://HOST:PORT. Needs prusa-slicer, xvfb, xdotool, openbox, dbus-daemon
# and the locale en_US.UTF-8; works in a folder of its own, which is gone afterwards.
set -euo pipefail
host_type=$1 address=$2
command -v prusa-slicer >/dev/null || { echo "prusa-slicer is not installed: skipped"; exit 77; }
folder=$(mktemp -d)
finish() {
  kill $(jobs -p) 2>/dev/null || true
  wait || true
  rm -rf "$folder"
}
trap finish EXIT
mkdir -p "$folder"/data/{printer,physical_printer,filament,print}

# Presets that exist keep its assistant away; the versions keep its questions away.
cat > "$folder/data/PrusaSlicer.ini" <<END
version = 2.9.2
version_system_info_sent = 2.9.2
show_splash_screen = 0
show_hints = 0
notify_release = none
preset_update = 0
view_mode = expert

[presets]
print = - default FFF print -
filament = - default FFF filament -
printer = StepFabric
physical_printer = StepFabric * StepFabric
END
cat > "$folder/data/printer/StepFabric.ini" <<END
printer_technology = FFF
bed_shape = 0x0,200x0,200x200,0x200
gcode_flavor = marlin2
nozzle_diameter = 0.4
max_print_height = 100
start_gcode = G28
end_gcode = M104 S0\nM140 S0\nM84
END
cat > "$folder/data/physical_printer/StepFabric.ini" <<END
preset_name = StepFabric
preset_names = StepFabric
printer_technology = FFF
host_type = $host_type
print_host = $address
printhost_authorization_type = key
printhost_apikey = 0123456789abcdef
END

# A plate of 10 x 10 x 2 mm as triangles of its corners 0 to 7: bit 0 is X, bit 1 Y, bit 2 Z.
{
  echo "solid plate"
  for corners in "0 2 1" "1 2 3" "4 5 6" "5 7 6" "0 1 4" "1 5 4" "2 6 3" "3 6 7" "0 4 2" "2 4 6" "1 3 5" "3 7 5"; do
    printf 'facet normal 0 0 0\nouter loop\n'
    for corner in $corners; do
      echo "vertex $((corner % 2 * 10)) $((corner / 2 % 2 * 10)) $((corner / 4 * 2))"
    done
    printf 'endloop\nendfacet\n'
  done
  echo "endsolid plate"
} > "$folder/plate.stl"

export DISPLAY=:77 LIBGL_ALWAYS_SOFTWARE=1 GDK_BACKEND=x11 NO_AT_BRIDGE=1 LANG=en_US.UTF-8
Xvfb "$DISPLAY" -screen 0 1400x900x24 +extension GLX > "$folder/xvfb.log" 2>&1 &
sleep 2
openbox > "$folder/openbox.log" 2>&1 &
dbus-run-session -- prusa-slicer --datadir "$folder/data" "$folder/plate.stl" > "$folder/slicer.log" 2>&1 &

window() { timeout "${2:-120}" xdotool search --sync --onlyvisible --name "$1" | tail -n 1; }
main=$(window 'based on Slic3r')
sleep 10  # until it has loaded the plate
xdotool windowactivate --sync "$main" key --clearmodifiers ctrl+r
sleep 10  # until it has sliced it
xdotool windowactivate --sync "$main" key --clearmodifiers ctrl+shift+g
dialog=$(window 'Send G-Code to printer host')
sleep 2
# From the name to `Upload`, and to `Upload and Print`.
xdotool windowactivate --sync "$dialog" key Tab Tab space
sleep 10
if [ -n "${SCREENSHOT:-}" ]; then import -window root "$SCREENSHOT"; fi
echo "sent"
